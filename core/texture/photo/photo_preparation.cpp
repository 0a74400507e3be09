#include "core/texture/photo/photo_preparation.h"

#include "core/support/errors.h"
#include "core/support/offenders.h"
#include "core/texture/photo/photo_overlays.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

void checkLens(const Lens& lens, Problems& problems) {
    addUnder(problems, "the lens", fieldProblems(lens.camera));
    addUnder(problems, "the lens", fieldProblems(lens));
}

void checkStrokes(const std::vector<PhotoStroke>& strokes, Problems& problems) {
    std::size_t places = 0;
    for (const PhotoStroke& stroke : strokes)
        places += stroke.path.size();
    if (strokes.size() > texture_limits::mostStrokes || places > texture_limits::mostPhotoPlaces)
        problems.push_back("there must be at most " + std::to_string(texture_limits::mostStrokes) +
                           " strokes, with " + std::to_string(texture_limits::mostPhotoPlaces) +
                           " places together");
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const std::string place = "strokes[" + std::to_string(i) + "]";
        if (strokes[i].path.empty()) addUnder(problems, place, {"the path has no place"});
        if (strokes[i].isFilled && strokes[i].path.size() < 3)
            addUnder(problems, place, {"an outline must have at least 3 places"});
        addUnder(problems, place, fieldProblems(strokes[i]));
    }
}

void checkCrop(const PhotoCrop& crop, int width, int height, Problems& problems) {
    const auto end = [](int place, int size) { return std::int64_t{place} + size; };
    if (crop.width < 1 || crop.height < 1 || crop.x < 0 || crop.y < 0 || end(crop.x, crop.width) > width ||
        end(crop.y, crop.height) > height)
        problems.push_back("the crop must be a part of the photo of " + std::to_string(width) + " × " +
                           std::to_string(height) + " pixels");
}

/// What is cut off becomes transparent and the picture keeps its size: places in it, of strokes and
/// landmarks, stay true.
void keepOnly(const PhotoCrop& crop, Image& photo) {
    tbb::parallel_for(0, photo.height, [&](int y) {
        const bool isRowKept = y >= crop.y && y - crop.y < crop.height;
        for (int x = 0; x < photo.width; ++x)
            if (!isRowKept || x < crop.x || x - crop.x >= crop.width) photo.at(x, y)[3] = 0;
    });
}

std::size_t shownPixels(const Image& photo) {
    std::size_t pixels = 0;
    for (std::size_t i = 3; i < photo.pixels.size(); i += 4)
        pixels += photo.pixels[i] > 0 ? 1 : 0;
    return pixels;
}

PixelMask highlightsIn(const Image& shown, const PhotoPreparation& preparation) {
    if (preparation.highlightSensitivity) return highlightMask(shown, *preparation.highlightSensitivity);
    if (preparation.highlightThreshold) return highlightsAbove(shown, *preparation.highlightThreshold);
    return {};
}

} // namespace

bool PhotoPreparation::isNothing() const {
    return *this == PhotoPreparation();
}

std::vector<std::string> validate(const PhotoPreparation& preparation, int width, int height) {
    Problems problems = fieldProblems(preparation);
    if (preparation.field) addUnder(problems, "the field", validate(*preparation.field));
    checkStrokes(preparation.strokes, problems);
    if (preparation.match)
        for (std::string& problem : fieldProblems(*preparation.match))
            problems.push_back(std::move(problem));
    if (preparation.lens) checkLens(*preparation.lens, problems);
    if (preparation.crop) checkCrop(*preparation.crop, width, height, problems);
    addUnder(problems, "the adjustment", validate(preparation.adjustment));
    return problems;
}

PhotoPreparation withFound(PhotoPreparation preparation, const Image& photo, StepsToFind steps) {
    if (steps.field) preparation.field = findField(photo);
    if (steps.overlays) {
        const std::vector<PhotoStroke> overlays = findOverlays(shownOf(photo, preparation));
        preparation.strokes.insert(preparation.strokes.begin(), overlays.begin(), overlays.end());
    }
    if (steps.whiteBalance) preparation.whiteBalance = findWhiteBalance(shownOf(photo, preparation));
    return preparation;
}

Image shownOf(const Image& photo, const PhotoPreparation& preparation) {
    Image shown = photo;
    if (preparation.field) maskField(shown, *preparation.field);
    maskStrokes(shown, preparation.strokes);
    return shown;
}

PixelMask highlightsOf(const Image& photo, const PhotoPreparation& preparation) {
    return preparation.fillsHighlights() ? highlightsIn(shownOf(photo, preparation), preparation)
                                         : PixelMask();
}

std::vector<std::string> warningsOf(const Image& photo, const PhotoPreparation& preparation) {
    std::vector<std::string> warnings;
    PhotoPreparation fieldAlone;
    fieldAlone.field = preparation.field;
    const std::size_t all = shownPixels(photo), inField = shownPixels(shownOf(photo, fieldAlone));
    if (preparation.field && inField == 0 && all > 0)
        warnings.emplace_back("the field leaves nothing of the photo; move it onto the picture");
    if (preparation.field && inField == all && all > 0)
        warnings.emplace_back("the field leaves all of the photo; make it smaller or remove it");
    if (!preparation.strokes.empty() && inField > 0 && shownPixels(shownOf(photo, preparation)) == 0)
        warnings.emplace_back("the mask leaves no pixel of the photo; restore a part of it");
    return warnings;
}

double highlightShare(const Image& photo, const PhotoPreparation& preparation) {
    if (!preparation.fillsHighlights()) return 0;
    const Image shown = shownOf(photo, preparation);
    const std::size_t pixels = shownPixels(shown);
    const PixelMask mask = highlightsIn(shown, preparation);
    const auto filled = std::count(mask.begin(), mask.end(), std::uint8_t{255});
    return pixels == 0 ? 0 : static_cast<double>(filled) / static_cast<double>(pixels);
}

/// The order matters. Highlights are filled while they still are white: evened light and white balance would
/// take them below the threshold. Colours are found on the photo as it was taken, and the lens comes after
/// them, so that field and strokes lie where they were drawn. What people like comes last: a picture that is
/// known without it is adjusted at once, see PhotoPreparer.
Image prepared(const Image& photo, const PhotoPreparation& preparation, const Progress& progress) {
    const Problems problems = validate(preparation, photo.width, photo.height);
    if (!problems.empty()) throw InvalidModel(problems);
    ProgressParts parts(progress);
    Image picture = shownOf(photo, preparation);
    reportProgress(parts.next(0.1), 1);
    const Progress filling = parts.next(0.4), evening = parts.next(0.2), matching = parts.next(0.1);
    if (preparation.fillsHighlights()) fillHighlights(picture, highlightsIn(picture, preparation), filling);
    evenLight(picture, preparation.evenLight);
    reportProgress(evening, 1);
    if (preparation.whiteBalance) multiplyColours(picture, *preparation.whiteBalance);
    if (preparation.match) applyMatch(picture, *preparation.match);
    reportProgress(matching, 1);
    if (preparation.lens) picture = undistorted(picture, *preparation.lens, parts.rest());
    if (preparation.crop) keepOnly(*preparation.crop, picture);
    adjustColours(picture, preparation.adjustment);
    reportProgress(progress, 1);
    return picture;
}

} // namespace esm
