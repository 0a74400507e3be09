#include "app/esmc/arguments.h"

#include "app/esmc/report.h"
#include "core/exchange/charts/chart_file.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/exchange/simulators/exporters.h"
#include "core/support/angles.h"
#include "core/support/letters.h"
#include "core/support/numbers.h"
#include "core/texture/photo/photo_format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace esm {

namespace {

std::string largestInText() {
    return roundedText(largestNumber);
}

/// Nothing of what is no number, or one that is larger than any quantity may be.
std::optional<double> usableNumber(const std::string& text) {
    double value = 0;
    if (!CLI::detail::lexical_cast(text, value) || !(std::abs(value) <= largestNumber)) return std::nullopt;
    return value;
}

double parseNumber(const std::string& text, const std::string& option) {
    const std::optional<double> value = usableNumber(text);
    if (!value) throw UsageError(option + ": '" + text + "' is not a number of at most " + largestInText());
    return *value;
}

const FuzzyVariable& inputOf(const FuzzySystem& system, const std::string& name, const std::string& option) {
    for (const FuzzyVariable& variable : system.inputs)
        if (variable.name == name) return variable;
    throw UsageError(option + ": '" + name + "' is not one of the system's inputs, " +
                     joinedNames(system.inputs));
}

/// A number, or the middle of a term's core, where it holds fully.
double valueOf(const FuzzyVariable& input, const std::string& word, const std::string& option) {
    if (const std::optional<double> number = usableNumber(word)) return *number;
    for (const FuzzyTerm& term : input.terms)
        if (term.name == word) return (term.set.b + term.set.c) / 2;
    throw UsageError(option + " " + input.name + ": '" + word +
                     "' is neither a number nor one of its terms, " + joinedNames(input.terms));
}

/// CLI11 itself would read leading zeros as octal. @param range " from 1 to 9", for the message
CLI::Validator decimal(int least, int most, const std::string& range) {
    const auto transform = [least, most, range](std::string& text) -> std::string {
        const std::optional<int> value = parseWholeNumber(text, least, most);
        if (!value) return "'" + text + "' is not a whole number" + range;
        text = std::to_string(*value);
        return "";
    };
    return CLI::Validator(transform, "");
}

/// What other programs take for it where a file is named.
constexpr const char* standardOutput = "-";
constexpr const char* toStandardOutput =
    "'-' would be standard output, to which no file is written; name a file";

bool isKnownEnding(const std::string& ending) {
    static const std::vector<std::string> others{".esm", ".csv", ".json", ".fcl", ".fll", ".webp"};
    const auto isOneOf = [](const std::string& word, const std::vector<std::string>& words) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    const std::string word = ending.substr(1);
    return isOneOf(ending, others) || isOneOf(word, photoFileEndings()) || isOneOf(word, meshFileEndings()) ||
           std::any_of(exporters().begin(), exporters().end(),
                       [&](const Exporter& exporter) { return exporter.ending == ending; });
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

NamedWords parseNamedWords(const std::vector<std::string>& pairs, const std::string& option) {
    NamedWords words;
    for (const std::string& pair : pairs) {
        const std::size_t equals = pair.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(option + ": '" + pair + "' is not of the form NAME=VALUE");
        const std::string name = pair.substr(0, equals);
        for (const auto& [other, word] : words)
            if (other == name) throw UsageError(option + ": '" + name + "' is given twice");
        words.emplace_back(name, pair.substr(equals + 1));
    }
    return words;
}

NamedValues parsePairs(const std::vector<std::string>& pairs, const std::string& option) {
    NamedValues values;
    for (const auto& [name, word] : parseNamedWords(pairs, option))
        values.emplace_back(name, parseNumber(word, option + " " + name));
    return values;
}

NamedValues inputsFor(const FuzzySystem& system, const NamedWords& words, const std::string& option) {
    NamedValues values;
    for (const auto& [name, word] : words)
        values.emplace_back(name, valueOf(inputOf(system, name, option), word, option));
    return values;
}

Ellipsoid parseEllipsoid(const std::string& text) {
    const std::vector<double> numbers = parseNumbers(text, "--ellipsoid");
    if (numbers.size() != 6 && numbers.size() != 10)
        throw UsageError(
            "--ellipsoid: give 6 numbers, \"cx cy cz rx ry rz\", or 10, with \"ax ay az degrees\"");
    Ellipsoid ellipsoid;
    ellipsoid.centre = {numbers[0], numbers[1], numbers[2]};
    ellipsoid.radii = {numbers[3], numbers[4], numbers[5]};
    if (!(ellipsoid.radii.minCoeff() > 0)) throw UsageError("--ellipsoid: the radii must be above zero");
    if (numbers.size() == 6) return ellipsoid;
    const Eigen::Vector3d axis(numbers[6], numbers[7], numbers[8]);
    if (!(axis.norm() > 0)) throw UsageError("--ellipsoid: the axis must have a length");
    ellipsoid.orientation = Eigen::AngleAxisd(toRadians(numbers[9]), axis.normalized());
    return ellipsoid;
}

std::vector<std::string> parseWords(const std::string& text, const std::vector<std::string>& known,
                                    const std::string& option) {
    std::vector<std::string> words;
    if (text.empty()) return words;
    std::istringstream stream(text + ','); // which ends the last word, be it empty
    for (std::string word; std::getline(stream, word, ',');) {
        if (std::find(known.begin(), known.end(), word) == known.end())
            throw UsageError(option + ": '" + word + "' is not one of " + joined(known));
        words.push_back(word);
    }
    return words;
}

CLI::Validator positiveNumber() {
    const auto check = [](const std::string& text) -> std::string {
        const std::optional<double> value = usableNumber(text);
        return value && *value > 0 ? ""
                                   : "'" + text + "' is not a number above zero, at most " + largestInText();
    };
    return CLI::Validator(check, "");
}

CLI::Validator numberWithin(double least, double most) {
    const auto check = [least, most](const std::string& text) -> std::string {
        const std::optional<double> value = usableNumber(text);
        return value && *value >= least && *value <= most
                   ? ""
                   : "'" + text + "' is not a number from " + roundedText(least) + " to " + roundedText(most);
    };
    return CLI::Validator(check, "");
}

CLI::Validator nonNegativeNumber() {
    return numberWithin(0, largestNumber);
}

std::optional<int> parseWholeNumber(const std::string& text, int least, int most) {
    const char* const end = text.data() + text.size();
    int value = 0;
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < least || value > most) return std::nullopt;
    return value;
}

CLI::Validator wholeNumber(int least, int most) {
    return decimal(least, most, " from " + std::to_string(least) + " to " + std::to_string(most));
}

CLI::Validator wholeNumber() {
    return decimal(std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), "");
}

std::string endingProblem(const std::string& file, const std::string& ending) {
    if (file == standardOutput) return toStandardOutput;
    const std::string given = endingOf(file);
    if (given.empty() || given == ending || !isKnownEnding(given)) return {};
    return "'" + file + "' does not end in " + ending + ", the kind of file that is written";
}

CLI::Validator writtenAs(const std::string& ending) {
    return CLI::Validator([ending](const std::string& file) { return endingProblem(file, ending); }, "");
}

CLI::Validator writtenAsChart() {
    const auto check = [](const std::string& file) -> std::string {
        return isChartFile(file) ? "" : "'" + file + "' ends neither in .svg nor in .png";
    };
    return CLI::Validator(check, "");
}

CLI::Validator namedFolder() {
    const auto check = [](const std::string& folder) -> std::string {
        return folder == standardOutput ? "'-' would be standard output; name a folder" : "";
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

CLI::Option* addSpringsChoice(CLI::App& command, bool& isEven) {
    return addChoice(
        command, "--springs", isEven, {{"even", true}, {"alike", false}},
        "even: each spring takes the share of its tissue's constant with which the surface is as "
        "firm however it is meshed; alike: each takes it as it is");
}

void addDampingOption(CLI::App& command, Damping& damping) {
    addChoice(command, "--damping", damping, {{"isotropic", Damping::Isotropic}, {"axial", Damping::Axial}},
              "Motion that viscosity damps: isotropic (all of it, the default) or axial (along the springs)");
}

} // namespace esm
