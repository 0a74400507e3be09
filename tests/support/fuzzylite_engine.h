#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fl {
class Engine;
}

/// A fuzzy system as an engine of fuzzylite, which samples the centre of gravity: a witness, and what ours is
/// compared with for speed.
class FuzzyliteEngine {
public:
    /// `resolution`: samples over the range of each output. Names must be in small letters, and NOT stand
    /// before single propositions only.
    FuzzyliteEngine(const esm::FuzzySystem& system, int resolution);
    /// As fuzzylite itself reads the languages. Throws what it throws.
    static FuzzyliteEngine fromFll(const std::string& text);
    static FuzzyliteEngine fromFcl(const std::string& text, int resolution);
    ~FuzzyliteEngine();
    FuzzyliteEngine(const FuzzyliteEngine&) = delete;
    FuzzyliteEngine& operator=(const FuzzyliteEngine&) = delete;

    void process(const std::vector<double>& inputs);
    std::vector<std::optional<double>> outputs() const; ///< empty where no rule fires

private:
    explicit FuzzyliteEngine(std::unique_ptr<fl::Engine> engine);

    std::unique_ptr<fl::Engine> m_engine;
};
