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

/// @throws UsageError
void parseLevels(const std::string& text, ColourAdjustment& adjustment) {
    const std::vector<double> numbers = parseNumbers(text, "--levels");
    if (numbers.size() != 3)
        throw UsageError("--levels: give three numbers, \"black white gamma\", as \"10 240 1.2\"");
    adjustment.blackPoint = numbers[0];
    adjustment.whitePoint = numbers[1];
    adjustment.gamma = numbers[2];
    const std::vector<std::string> problems = validate(adjustment);
    if (!problems.empty()) throw UsageError("--levels: " + problems.front());
}

/// @throws UsageError
Eigen::Vector2d parseSpot(const std::string& text, const Image& photo) {
    const std::vector<double> numbers = parseNumbers(text, "--white-spot");
    if (numbers.size() != 2 || !(numbers[0] >= 0) || !(numbers[1] >= 0) || numbers[0] > photo.width ||
        numbers[1] > photo.height)
        throw UsageError("--white-spot: give a place in the photograph, \"x y\" in its pixels");
    return {numbers[0], numbers[1]};
}

/// White as it is asked for, by what the preparation leaves of the photo.
std::optional<ColourGains> whiteBalanceFor(const PreparationOptions& options, const Image& photo,
                                           const PhotoPreparation& preparation) {
    const Image shown = shownOf(photo, preparation);
    if (!options.whiteLike.empty()) {
        Image other = loadPhoto(options.whiteLike)->image;
        if (const auto field = findField(other)) maskField(other, *field);
        return whiteBalanceLike(shown, other);
    }
    if (!options.whiteSpot.empty()) return whiteBalanceOfSpot(shown, parseSpot(options.whiteSpot, photo));
    return options.whiteBalance ? findWhiteBalance(shown) : std::nullopt;
}

std::string gainsInText(const ColourGains& gains) {
    return inText(gains[0]) + ", " + inText(gains[1]) + ", " + inText(gains[2]);
}

std::string fieldInText(const PhotoField& field) {
    const std::string around = " pixels around " + inText(field.centre.x()) + ", " + inText(field.centre.y());
    if (field.isCircle()) return "circle of radius " + inText(field.radii.x()) + around;
    if (field.shape == FieldShape::Polygon)
        return "polygon of " + std::to_string(field.corners.size()) + " corners";
    return "ellipse of radii " + inText(field.radii.x()) + " and " + inText(field.radii.y()) + around;
}

void reportField(const std::optional<PhotoField>& field, Report& report) {
    report.json["field"] = nullptr;
    if (field) {
        report.json["field"] = written(*field);
        report.text.push_back("field: " + fieldInText(*field) + ", " + inText(field->trim) + " % trimmed");
    } else {
        report.text.emplace_back("field: none found, the picture fills the frame");
    }
}

void reportOverlays(std::size_t overlays, Report& report) {
    report.json["overlays_masked"] = overlays;
    report.text.push_back("text and boxes: " + std::to_string(overlays) + " masked");
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
        report.text.emplace_back(
            "white balance: not changed, as nothing shows the lamp's colour for sure; choose a "
            "white spot by --white-spot, or a balanced photograph by --white-like");
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

void declareAdjustment(CLI::App& command, PreparationOptions& options) {
    command.add_option("--levels", options.levels,
                       "Take these values to black and white and bend what lies between by gamma, \"black "
                       "white gamma\"; \"0 255 1\" changes nothing");
    command
        .add_option("--contrast", options.adjustment.contrast,
                    "Multiply what differs from middle grey, from 0 to 2")
        ->check(numberWithin(0, 2));
    command
        .add_option("--saturation", options.adjustment.saturation,
                    "Multiply how colourful it is, from 0 (grey) to 2")
        ->check(numberWithin(0, 2));
    command
        .add_option("--hue", options.adjustment.hue,
                    "Turn its hues by so many degrees, from -180 to 180, red towards yellow")
        ->check(numberWithin(-180, 180));
}

} // namespace

void declarePreparation(CLI::App& command, PreparationOptions& options) {
    command.add_flag("--field,--round-field", options.field,
                     "Show only the endoscope's field, round or not, where one is found");
    command.add_flag("--mask-overlays", options.maskOverlays, "Erase text and boxes that are burnt in");
    command.add_flag("--fill-highlights", options.fillHighlights,
                     "Fill specular highlights from their surroundings");
    command
        .add_option("--highlights", options.highlights,
                    "Fill them, from 0 (only what is white) to 1 (faint shine too); 0.5 without")
        ->check(numberWithin(0, 1));
    command
        .add_option("--even-light", options.evenLight, "Even uneven light out, from 0 (not) to 1 (wholly)")
        ->check(numberWithin(0, 1));
    auto* balance = command.add_flag("--white-balance", options.whiteBalance,
                                     "Make white what shows the lamp's colour, where that is found");
    auto* spot = command
                     .add_option("--white-spot", options.whiteSpot,
                                 "Make this spot grey, \"x y\" in pixels of the photograph")
                     ->excludes(balance);
    command
        .add_option("--white-like", options.whiteLike,
                    "Give its tissue the colour of the tissue in this balanced photograph")
        ->excludes(balance)
        ->excludes(spot);
    command.add_flag("--match-colours", options.matchColours, "Give it the colours of the surface beneath");
    declareAdjustment(command, options);
    command.add_option("--lens", options.lens, "Correct the distortion of this lens (.json)");
    command.add_option("--crop", options.crop,
                       "Keep only this part, \"x y width height\" in pixels of the photograph");
}

Report prepareLayer(const Project& project, TextureLayer& layer, const PreparationOptions& options) {
    const Image& photo = layer.photo->image;
    Report report;
    PhotoPreparation preparation;
    if (!options.crop.empty()) preparation.crop = parseCrop(options.crop);
    if (!options.lens.empty()) preparation.lens = readLensFile(options.lens);
    if (options.fillHighlights) preparation.highlightSensitivity = usualSensitivity;
    if (options.highlights) preparation.highlightSensitivity = options.highlights;
    preparation.evenLight = options.evenLight;
    preparation.adjustment = options.adjustment;
    if (!options.levels.empty()) parseLevels(options.levels, preparation.adjustment);
    // What steps find in the photo is stored as numbers, so that it stays what it was seen to be.
    preparation = withFound(preparation, photo, {options.field, false, options.maskOverlays});
    preparation.whiteBalance = whiteBalanceFor(options, photo, preparation);
    layer.preparation = preparation;
    if (options.matchColours)
        preparation.match = matchToSurface(*project.mesh, project.layers, project.texture.baseColour, layer);
    const double highlights =
        highlightShare(photo, preparation); // while there is no second picture of it yet
    prepare(layer, preparation);
    if (options.field) reportField(preparation.field, report);
    if (options.maskOverlays) reportOverlays(preparation.strokes.size(), report);
    if (preparation.fillsHighlights()) reportHighlights(highlights, report);
    if (options.whiteBalance || !options.whiteSpot.empty() || !options.whiteLike.empty())
        reportGains(preparation.whiteBalance, report);
    if (options.matchColours) reportMatch(preparation.match, report);
    return report;
}

} // namespace esm
