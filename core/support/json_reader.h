#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace esm {

/// Parses JSON text that cannot be trusted. @throws InvalidModel: not JSON (line and column), a key that one
/// object names twice, or nested beyond all use
nlohmann::ordered_json parseJson(const char* begin, const char* end);

/// What parseJson() checks, without the result. @throws InvalidModel
void guardJson(const char* begin, const char* end);

/// @throws FileError: what readFile() and parseJson() throw; of more than 64 MiB
nlohmann::ordered_json readJsonFile(const std::filesystem::path& file);

/// Places of numbers that JSON cannot hold (NaN, infinite), as "regions[0].held.mass".
std::vector<std::string> nonFiniteNumbers(const nlohmann::ordered_json& json);

/// A value in JSON that cannot be trusted. What is missing or of another kind is noted as a problem that
/// names the place, once, and reads as a harmless default, so that one pass finds every problem.
class JsonReader {
public:
    /// Both references must outlive the reader and all readers made from it.
    JsonReader(const nlohmann::ordered_json& json, std::string place, std::vector<std::string>& problems);

    bool has(const char* key) const;                                 ///< present and not null
    bool isObject() const;                                           ///< all else is a problem
    JsonReader member(const char* key) const;                        ///< a missing one is a problem
    std::vector<JsonReader> elements() const;                        ///< of a list
    std::vector<std::pair<std::string, JsonReader>> members() const; ///< of an object, in the file's order

    /// Notes every other member as a problem, so that a misspelt one is not lost.
    void allowOnly(const std::vector<std::string>& keys) const;

    std::string text() const;
    bool flag() const;
    double number() const; ///< finite
    std::uint64_t integer(std::uint64_t least, std::uint64_t most) const;
    std::size_t count() const {
        return static_cast<std::size_t>(integer(0, std::numeric_limits<std::size_t>::max()));
    }
    std::vector<double> numbers(std::size_t size) const; ///< a list of exactly `size` numbers
    Eigen::Vector3d vector() const;
    std::vector<std::string> texts() const;

    /// A reader of a missing value: one whose problem is known already.
    JsonReader nothing() const { return {nullptr, m_place, m_problems}; }
    /// The bare value, null where it is missing.
    const nlohmann::ordered_json& json() const;
    const std::string& place() const { return m_place; }
    void addProblem(const std::string& problem) const;

private:
    JsonReader(const nlohmann::ordered_json* json, std::string place, std::vector<std::string>* problems)
        : m_json(json), m_place(std::move(place)), m_problems(problems) {}

    const nlohmann::ordered_json* m_json; ///< null: missing, and said so already
    std::string m_place;
    std::vector<std::string>* m_problems;
};

/// @throws InvalidModel where the file's `version` is a newer one than `known`
void refuseNewerVersion(const JsonReader& file, int known);

} // namespace esm
