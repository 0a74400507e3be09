#include "app/esmc/preparation_options.h"

#include "core/exchange/preparation_json.h"

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
    if (numbers.size() != 4 || !std::all_of(numbers.begin(), numbers.end(), isPixel))
        throw UsageError("--crop takes four whole numbers, \"x y width height\" in pixels of the photograph");
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1]), static_cast<int>(numbers[2]),
            static_cast<int>(numbers[3])};
}

std::string gainsInText(const ColourGains& gains) {
    return inText(gains[0]) + ", " + inText(gains[1]) + ", " + inText(gains[2]);
}

/// What steps find in the photo is stored as numbers, so that it stays what it was seen to be.
void findField(const Image& photo, PhotoPreparation& preparation, Report& report) {
    preparation.field = findRoundField(photo);
    report.json["round_field"] = nullptr;
    if (const auto& field = preparation.field) {
        report.json["round_field"] = {
            {"centre", {field->centreX, field->centreY}}, {"radius", field->radius}, {"trim", field->trim}};
        report.text.push_back("round field: radius " + inText(field->radius) + " pixels around " +
                              inText(field->centreX) + ", " + inText(field->centreY) + ", " +
                              inText(field->trim) + " % trimmed");
    } else {
        report.text.emplace_back("round field: none found");
    }
}

/// The share that is filled of what the field leaves.
void countHighlights(const Image& photo, const PhotoPreparation& preparation, Report& report) {
    PhotoPreparation field;
    field.field = preparation.field;
    Image picture = prepared(photo, field);
    std::size_t shown = 0;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4)
        shown += picture.pixels[i] > 0 ? 1 : 0;
    const std::size_t filled = fillHighlights(picture, *preparation.highlightThreshold);
    const double share = shown > 0 ? static_cast<double>(filled) / static_cast<double>(shown) : 0;
    report.json["highlights_filled"] = share;
    report.text.push_back("highlights: " + inText(100 * share) + " % filled");
}

void findGains(const Image& photo, PhotoPreparation& preparation, Report& report) {
    PhotoPreparation before = preparation;
    before.lens.reset();
    before.crop.reset();
    preparation.whiteBalance = findWhiteBalance(prepared(photo, before));
    report.json["white_balance"] = nullptr;
    if (preparation.whiteBalance) {
        report.json["white_balance"] = *preparation.whiteBalance;
        report.text.push_back("white balance: red, green, blue × " + gainsInText(*preparation.whiteBalance));
    } else {
        report.text.emplace_back("white balance: nothing nearly grey found to go by");
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
    command.add_option("--lens", options.lens, "Straighten what this lens bends (.json)");
    command.add_option("--crop", options.crop,
                       "Keep only this part, \"x y width height\" in pixels of the photograph");
}

Report prepareLayer(TextureLayer& layer, const PreparationOptions& options) {
    const Image& photo = layer.photo->image;
    Report report;
    PhotoPreparation preparation;
    if (!options.crop.empty()) preparation.crop = parseCrop(options.crop);
    if (!options.lens.empty()) preparation.lens = readLensFile(options.lens);
    if (options.roundField) findField(photo, preparation, report);
    if (options.fillHighlights) {
        preparation.highlightThreshold = usualHighlightThreshold;
        countHighlights(photo, preparation, report);
    }
    preparation.evenLight = options.evenLight;
    if (options.whiteBalance) findGains(photo, preparation, report);
    prepare(layer, preparation);
    return report;
}

} // namespace esm
