#include "app/esmc/arguments.h"

#include "app/esmc/report.h"
#include "core/support/angles.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace esm {

namespace {

double parseNumber(const std::string& text, const std::string& option) {
    double value = 0;
    if (!CLI::detail::lexical_cast(text, value) || !std::isfinite(value))
        throw UsageError(option + ": '" + text + "' is not a number");
    return value;
}

} // namespace

std::vector<double> parseNumbers(const std::string& text, const std::string& option) {
    std::string spaced = text;
    std::replace(spaced.begin(), spaced.end(), ',', ' ');
    std::istringstream words(spaced);
    std::vector<double> numbers;
    for (std::string word; words >> word;)
        numbers.push_back(parseNumber(word, option));
    return numbers;
}

NamedValues parsePairs(const std::vector<std::string>& pairs, const std::string& option) {
    NamedValues values;
    for (const std::string& pair : pairs) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(option + ": '" + pair + "' is not of the form NAME=VALUE");
        const std::string name = pair.substr(0, equals);
        for (const auto& [other, value] : values)
            if (other == name) throw UsageError(option + ": '" + name + "' is given twice");
        values.emplace_back(name, parseNumber(pair.substr(equals + 1), option + " " + name));
    }
    return values;
}

Ellipsoid parseEllipsoid(const std::string& text) {
    const std::vector<double> n = parseNumbers(text, "--ellipsoid");
    if (n.size() != 6 && n.size() != 10)
        throw UsageError(
            "--ellipsoid: give 6 numbers, \"cx cy cz rx ry rz\", or 10, with \"ax ay az degrees\"");
    Ellipsoid ellipsoid;
    ellipsoid.centre = {n[0], n[1], n[2]};
    ellipsoid.radii = {n[3], n[4], n[5]};
    if (!(ellipsoid.radii.minCoeff() > 0)) throw UsageError("--ellipsoid: the radii must be above zero");
    if (n.size() == 6) return ellipsoid;
    const Eigen::Vector3d axis(n[6], n[7], n[8]);
    if (!(axis.norm() > 0)) throw UsageError("--ellipsoid: the axis must have a length");
    ellipsoid.orientation = Eigen::AngleAxisd(toRadians(n[9]), axis.normalized());
    return ellipsoid;
}

std::vector<std::string> parseWords(const std::string& text, const std::vector<std::string>& known,
                                    const std::string& option) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) {
        if (std::find(known.begin(), known.end(), word) == known.end())
            throw UsageError(option + ": '" + word + "' is not one of " + joined(known));
        words.push_back(word);
    }
    return words;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : ", ") + word;
    return text;
}

CLI::Validator positiveNumber() {
    const auto check = [](const std::string& text) -> std::string {
        double value = 0;
        const bool isPositive = CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
        return isPositive ? "" : "'" + text + "' is not a number above zero";
    };
    return CLI::Validator(check, "");
}

CLI::Validator oneOf(const std::vector<std::string>& values) {
    const auto check = [values](const std::string& text) -> std::string {
        const bool isKnown = std::find(values.begin(), values.end(), text) != values.end();
        return isKnown ? "" : "'" + text + "' is not one of " + joined(values);
    };
    return CLI::Validator(check, "");
}

} // namespace esm
