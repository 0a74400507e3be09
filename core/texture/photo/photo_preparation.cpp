#include "core/texture/photo/photo_preparation.h"

#include "core/support/errors.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

using Problems = std::vector<std::string>;

constexpr double mostTrim = 90; ///< percent
constexpr double largestCoefficient = 1e3;
constexpr double widestBrush = 5000; ///< pixels

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most; // not so for NaN
}

void checkField(const RoundField& field, Problems& problems) {
    const double far = texture_limits::longestFocalLength;
    if (!isWithin(field.radius, 1, far) || !isWithin(field.centreX, -far, far) ||
        !isWithin(field.centreY, -far, far))
        problems.emplace_back(
            "the round field must have a radius of 1 to 1e7 pixels and a centre within 1e7");
    if (!isWithin(field.trim, 0, mostTrim))
        problems.emplace_back("the round field must be trimmed by 0 to 90 %");
}

void checkLens(const Lens& lens, Problems& problems) {
    const double most = texture_limits::longestFocalLength;
    for (const double focal : {lens.camera.fx, lens.camera.fy})
        if (!(focal > 0) || focal > most) {
            problems.emplace_back("the lens must have a focal length above 0 and up to 1e7 pixels");
            break;
        }
    if (!isWithin(lens.camera.cx, -most, most) || !isWithin(lens.camera.cy, -most, most))
        problems.emplace_back("the lens must have its centre within 1e7 pixels");
    const auto isSane = [](double c) { return isWithin(c, -largestCoefficient, largestCoefficient); };
    if (!std::all_of(lens.coefficients.begin(), lens.coefficients.end(), isSane))
        problems.emplace_back("the lens's coefficients must lie between -1000 and 1000");
}

void checkStrokes(const std::vector<PhotoStroke>& strokes, Problems& problems) {
    const double far = texture_limits::longestFocalLength;
    const auto isPlace = [&](const Eigen::Vector2d& place) {
        return isWithin(place.x(), -far, far) && isWithin(place.y(), -far, far);
    };
    const auto isSound = [&](const PhotoStroke& stroke) {
        return !stroke.path.empty() && std::all_of(stroke.path.begin(), stroke.path.end(), isPlace) &&
               isWithin(stroke.radius, 0.5, widestBrush) && isWithin(stroke.softness, 0, 1);
    };
    std::size_t places = 0;
    for (const PhotoStroke& stroke : strokes)
        places += stroke.path.size();
    if (strokes.size() > texture_limits::mostStrokes || places > texture_limits::mostPhotoPlaces)
        problems.push_back("there must be at most " + std::to_string(texture_limits::mostStrokes) +
                           " strokes, with " + std::to_string(texture_limits::mostPhotoPlaces) +
                           " places together");
    if (!std::all_of(strokes.begin(), strokes.end(), isSound))
        problems.emplace_back(
            "strokes must have places within 1e7 pixels, a radius of 0.5 to 5000 pixels and a "
            "softness of 0 to 1");
}

void checkMatch(const ColourMatch& match, Problems& problems) {
    const auto all = [](const std::array<double, 3>& values, double least, double most) {
        return std::all_of(values.begin(), values.end(),
                           [=](double value) { return isWithin(value, least, most); });
    };
    if (!all(match.scale, smallestSpread, largestSpread) || !all(match.offset, -largestShift, largestShift))
        problems.emplace_back(
            "matched colours must have scales of 0.5 to 2 and offsets between -300 and 300");
}

void checkCrop(const PhotoCrop& crop, int width, int height, Problems& problems) {
    const auto end = [](int place, int size) { return std::int64_t{place} + size; };
    if (crop.width < 1 || crop.height < 1 || crop.x < 0 || crop.y < 0 || end(crop.x, crop.width) > width ||
        end(crop.y, crop.height) > height)
        problems.push_back("the crop must be a part of the photo of " + std::to_string(width) + " × " +
                           std::to_string(height) + " pixels");
}

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
    Problems problems;
    if (preparation.field) checkField(*preparation.field, problems);
    checkStrokes(preparation.strokes, problems);
    if (preparation.highlightThreshold && !isWithin(*preparation.highlightThreshold, 1, 255))
        problems.emplace_back("the threshold of highlights must lie between 1 and 255");
    if (!isWithin(preparation.evenLight, 0, 1))
        problems.emplace_back("the strength of even light must lie between 0 and 1");
    if (preparation.whiteBalance &&
        !std::all_of(preparation.whiteBalance->begin(), preparation.whiteBalance->end(),
                     [](double gain) { return isWithin(gain, smallestGain, largestGain); }))
        problems.emplace_back("the gains of white balance must lie between 0.25 and 4");
    if (preparation.match) checkMatch(*preparation.match, problems);
    if (preparation.lens) checkLens(*preparation.lens, problems);
    if (preparation.crop) checkCrop(*preparation.crop, width, height, problems);
    return problems;
}

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
    Image picture = shownOf(photo, preparation);
    reportProgress(progress, 0.2);
    if (preparation.highlightThreshold) fillHighlights(picture, *preparation.highlightThreshold);
    reportProgress(progress, 0.4);
    evenLight(picture, preparation.evenLight);
    if (preparation.whiteBalance) multiplyColours(picture, *preparation.whiteBalance);
    if (preparation.match) applyMatch(picture, *preparation.match);
    reportProgress(progress, 0.6);
    if (preparation.lens) picture = undistorted(picture, *preparation.lens);
    if (preparation.crop) keepOnly(*preparation.crop, picture);
    return picture;
}

} // namespace esm
