#include "app/esmc/report.h"

#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>

namespace esm {

namespace {

std::string warningLine(const std::string& warning) {
    return "warning: " + warning;
}

} // namespace

std::string inText(double value) {
    return roundedText(value, 4);
}

std::string inText(const Eigen::Vector3d& value) {
    return inText(value.x()) + ", " + inText(value.y()) + ", " + inText(value.z());
}

std::string counted(std::size_t count, const std::string& noun, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

Json inJson(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json();
}

Json inJson(const Eigen::Vector3d& value) {
    return Json::array({value.x(), value.y(), value.z()});
}

void addWarnings(Report& report, const std::vector<std::string>& warnings) {
    report.json["warnings"] = warnings;
    for (const std::string& warning : warnings)
        report.text.push_back(warningLine(warning));
}

void addFileWarnings(Report& report, const std::vector<std::string>& warnings) {
    if (warnings.empty()) return;
    const Json own = report.json.value("warnings", Json::array());
    report.json["warnings"] = warnings;
    report.json["warnings"].insert(report.json["warnings"].end(), own.begin(), own.end());
    std::transform(warnings.begin(), warnings.end(), std::inserter(report.text, report.text.begin()),
                   warningLine);
}

void addWritten(Report& report, const std::filesystem::path& file) {
    report.text.push_back("wrote " + file.string());
}

void print(const Report& report, bool asJson) {
    // Names out of foreign files may hold bytes that are no UTF-8.
    if (asJson)
        std::cout << report.json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        for (const std::string& line : report.text)
            std::cout << line << '\n';
    if (!std::cout.flush()) throw FileError("standard output", "cannot be written; free some space");
}

void printError(std::string message) {
    std::replace_if(
        message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    std::cerr << "esmc: " << message << std::endl;
}

} // namespace esm
