#include "core/texture/photo/photo_preparation.h"

#include "core/support/errors.h"
#include "core/support/offenders.h"
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

/// The photo without what is left out before anything is done to it.
Image shownOf(const Image& photo, const PhotoPreparation& preparation) {
    Image shown = photo;
    if (preparation.field) maskField(shown, *preparation.field);
    maskStrokes(shown, preparation.strokes);
    return shown;
}

} // namespace

bool PhotoPreparation::isNothing() const {
    return *this == PhotoPreparation();
}

std::vector<std::string> validate(const PhotoPreparation& preparation, int width, int height) {
    Problems problems = fieldProblems(preparation);
    if (preparation.field) addUnder(problems, "the round field", fieldProblems(*preparation.field));
    checkStrokes(preparation.strokes, problems);
    if (preparation.match)
        for (std::string& problem : fieldProblems(*preparation.match))
            problems.push_back(std::move(problem));
    if (preparation.lens) checkLens(*preparation.lens, problems);
    if (preparation.crop) checkCrop(*preparation.crop, width, height, problems);
    return problems;
}

/// The field first: the white balance must not look at what the field leaves out.
PhotoPreparation withFound(PhotoPreparation preparation, const Image& photo, StepsToFind steps) {
    if (steps.field) preparation.field = findRoundField(photo);
    if (steps.whiteBalance) preparation.whiteBalance = findWhiteBalance(shownOf(photo, preparation));
    return preparation;
}

double highlightShare(const Image& photo, const PhotoPreparation& preparation) {
    if (!preparation.highlightThreshold) return 0;
    const Image shown = shownOf(photo, preparation);
    std::size_t pixels = 0;
    for (std::size_t i = 3; i < shown.pixels.size(); i += 4)
        pixels += shown.pixels[i] > 0 ? 1 : 0;
    if (pixels == 0) return 0;
    return static_cast<double>(countHighlights(shown, *preparation.highlightThreshold)) /
           static_cast<double>(pixels);
}

/// The order matters. Highlights are filled while they still are white: evened light and white balance would
/// take them below the threshold. Colours are changed on the photo as it was taken, and the lens comes last,
/// so that field and strokes lie where they were drawn.
Image prepared(const Image& photo, const PhotoPreparation& preparation, const Progress& progress) {
    const Problems problems = validate(preparation, photo.width, photo.height);
    if (!problems.empty()) throw InvalidModel(problems);
    ProgressParts parts(progress);
    Image picture = shownOf(photo, preparation);
    reportProgress(parts.next(0.1), 1);
    const Progress filling = parts.next(0.4), evening = parts.next(0.2), matching = parts.next(0.1);
    if (preparation.highlightThreshold) fillHighlights(picture, *preparation.highlightThreshold, filling);
    evenLight(picture, preparation.evenLight);
    reportProgress(evening, 1);
    if (preparation.whiteBalance) multiplyColours(picture, *preparation.whiteBalance);
    if (preparation.match) applyMatch(picture, *preparation.match);
    reportProgress(matching, 1);
    if (preparation.lens) picture = undistorted(picture, *preparation.lens, parts.rest());
    if (preparation.crop) keepOnly(*preparation.crop, picture);
    reportProgress(progress, 1);
    return picture;
}

} // namespace esm
