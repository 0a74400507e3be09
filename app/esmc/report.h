#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace esm {

using Json = nlohmann::ordered_json;

/// What a command hands back: the same facts for programs and for people.
struct Report {
    Json json = Json::object(); ///< the keys of `docs/command-line.md`
    std::vector<std::string> text;
    std::string failure; ///< not empty: the work failed all the same, exit code 1
};

/// A command that was typed wrongly: exit code 2.
class UsageError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Numbers for people: four significant digits.
std::string inText(double value);
std::string inText(const Eigen::Vector3d& value);

/// "1 node", "12 nodes", "2 vertices".
std::string counted(std::size_t count, const std::string& noun, const std::string& plural = "");

Json inJson(const std::optional<double>& value); ///< null without a value
Json inJson(const Eigen::Vector3d& value);

void addWarnings(Report& report,
                 const std::vector<std::string>& warnings); ///< `warnings` in JSON, a line each
/// Beside and before those that it has; nothing where there are none.
void addFileWarnings(Report& report, const std::vector<std::string>& warnings);
void addWritten(Report& report, const std::filesystem::path& file); ///< the text line that names an output

/// Prints to standard output. @throws FileError when that cannot be written
void print(const Report& report, bool asJson);

/// Prints `esmc: message` as one line on standard error, whatever the message holds.
void printError(std::string message);

} // namespace esm
