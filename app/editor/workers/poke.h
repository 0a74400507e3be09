#pragma once

#include "app/editor/workers/preview_loads.h"
#include "core/model/spring_network.h"

#include <memory>
#include <vector>

namespace esm {

/// What a hand does from a moment of the tissue's time on.
struct HandMoment {
    double time; ///< s
    PreviewLoads loads;
};

/// What a hand did to an organ that rested, in the tissue's own time, so that another tissue can be poked in
/// the same way.
struct Poke {
    std::shared_ptr<const SpringNetwork> network; ///< that pulled nodes are counted in
    double duration = 0;                          ///< s
    std::vector<HandMoment> moments;              ///< times strictly increasing; each lasts until the next
};

/// A longer one ends by itself.
inline constexpr double longestPoke = 30; // s

/// What acts at a time; nothing before the first moment.
PreviewLoads loadsAt(const Poke& poke, double time);

/// The same on another net of the organ: pulls take hold of the nearest node, and go as far.
Poke carriedOver(const Poke& poke, const std::shared_ptr<const SpringNetwork>& network);

/// Writes down what a hand does.
class PokeRecorder {
public:
    explicit PokeRecorder(std::shared_ptr<const SpringNetwork> network) {
        m_poke.network = std::move(network);
    }

    /// What acts from a time on, s. What came later is forgotten: the run went back.
    void note(double time, PreviewLoads loads);
    /// That the last went on until a time, s.
    void goOn(double time) { m_poke.duration = time; }
    const Poke& poke() const { return m_poke; }

private:
    Poke m_poke;
};

} // namespace esm
