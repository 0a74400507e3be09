#include "app/esmc/preparation_options.h"

#include "core/exchange/fields_json.h"
#include "core/exchange/project/preparation_json.h"
#include "core/texture/layers/surface_match.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

PhotoCrop parseCrop(const std::string& text) {
    const std::vector<double> numbers = parseNumbers(text, "--crop");
    constexpr double most = 1e6;
    const auto isPixel = [](double value) {
        return value >= 0 && value <= most && value == std::floor(value);
    };
    if (numbers.size() != 4 || !std::all_of(numbers.begin(), numbers.end(), isPixel) ||
        std::min(numbers[2], numbers[3]) < 1)
        throw UsageError("--crop: give four whole numbers, \"x y width height\" in pixels of the photograph");
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
            static_cast<int>(numbers[3])};
}

std::string gainsInText(const ColourGains& gains) {
    return inText(gains[0]) + ", " + inText(gains[1]) + ", " + inText(gains[2]);
}

void reportField(const std::optional<RoundField>& field, Report& report) {
    report.json["round_field"] = nullptr;
    if (field) {
        report.json["round_field"] = written(*field);
        report.text.push_back("round field: radius " + inText(field->radius) + " pixels around " +
                              inText(field->centre.x()) + ", " + inText(field->centre.y()) + ", " +
                              inText(field->trim) + " % trimmed");
    } else {
        report.text.emplace_back("round field: none found");
    }
}

void reportHighlights(double share, Report& report) {
    report.json["highlights_filled"] = share;
    report.text.push_back("highlights: " + inText(100 * share) + " % filled");
}

void reportGains(const std::optional<ColourGains>& gains, Report& report) {
    report.json["white_balance"] = nullptr;
    if (gains) {
        report.json["white_balance"] = *gains;
        report.text.push_back("white balance: red, green, blue × " + gainsInText(*gains));
    } else {
        report.text.emplace_back("white balance: nothing nearly grey found to go by");
    }
}

void reportMatch(const std::optional<ColourMatch>& match, Report& report) {
    report.json["colour_match"] = nullptr;
    if (match) {
        report.json["colour_match"] = {{"scale", match->scale}, {"offset", match->offset}};
        report.text.emplace_back("colours: matched to what lies beneath");
    } else {
        report.text.emplace_back("colours: not matched, the photograph meets too little of the surface");
    }
}

} // namespace

void declarePreparation(CLI::App& command, PreparationOptions& options) {
    command.add_flag("--round-field", options.roundField,
                     "Show only the endoscope's round field, where one is found");
    command.add_flag("--fill-highlights", options.fillHighlights,
                     "Fill specular highlights from their surroundings");
    command
        .add_option("--even-light", options.evenLight, "Even uneven light out, from 0 (not) to 1 (wholly)")
        ->check(numberWithin(0, 1));
    command.add_flag("--white-balance", options.whiteBalance, "Make what is nearly grey grey");
    command.add_flag("--match-colours", options.matchColours, "Give it the colours of the surface beneath");
    command.add_option("--lens", options.lens, "Straighten what this lens bends (.json)");
    command.add_option("--crop", options.crop,
                       "Keep only this part, \"x y width height\" in pixels of the photograph");
}

Report prepareLayer(const Project& project, TextureLayer& layer, const PreparationOptions& options) {
    const Image& photo = layer.photo->image;
    Report report;
    PhotoPreparation preparation;
    if (!options.crop.empty()) preparation.crop = parseCrop(options.crop);
    if (!options.lens.empty()) preparation.lens = readLensFile(options.lens);
    if (options.fillHighlights) preparation.highlightThreshold = usualHighlightThreshold;
    preparation.evenLight = options.evenLight;
    // What steps find in the photo is stored as numbers, so that it stays what it was seen to be.
    preparation = withFound(preparation, photo, {options.roundField, options.whiteBalance});
    layer.preparation = preparation;
    if (options.matchColours)
        preparation.match = matchToSurface(*project.mesh, project.layers, project.texture.baseColour, layer);
    prepare(layer, preparation);
    if (options.roundField) reportField(preparation.field, report);
    if (options.fillHighlights) reportHighlights(highlightShare(photo, preparation), report);
    if (options.whiteBalance) reportGains(preparation.whiteBalance, report);
    if (options.matchColours) reportMatch(preparation.match, report);
    return report;
}

} // namespace esm
