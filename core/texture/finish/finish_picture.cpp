#include "core/texture/finish/finish_picture.h"

#include "core/support/smooth_step.h"
#include "core/texture/photo/photo_sampler.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int noHeight = 128;
constexpr float heightSteps = 127; ///< of blue, from none to the greatest

// In parts of the picture's diagonal, so that the same photo in another size has the same finish.
constexpr double filmSpread = 0.006; ///< by which the film goes on around a highlight
constexpr float strengthened = 4;    ///< flecks are small, and would vanish in what they spread over
constexpr double detailWidth = 0.01; ///< what is wider is no detail but form and light

constexpr double noiseWidth = 0.8;    ///< pixels, below which is noise of the camera
constexpr float darkestSurround = 16; ///< of 255: what is darker has too much noise in relation
/// Of 255: surroundings as dark as the first tell nothing of relief, as the noise of a camera is all their
/// detail; those as bright as the second tell all.
constexpr float allNoise = 12, littleNoise = 48;
constexpr float heightAtHalf = 2;       ///< half as bright again is as high as the relief says
constexpr float leastDetail = 0.03F;    ///< of the brightness: three steps of 8 bits in a photo of medium one
constexpr double smoothUnderFilm = 0.6; ///< of the roughness, that a film takes away at most

double diagonalOf(const Image& picture) {
    return std::hypot(picture.width, picture.height);
}

std::uint8_t byteOf(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

cv::Mat1f blurred(const cv::Mat1f& values, double deviation) {
    cv::Mat1f result;
    cv::GaussianBlur(values, result, {}, deviation, deviation, cv::BORDER_REFLECT);
    return result;
}

/// How much of the film is added at every pixel, 0 to 1. Where the lamp's mirror image is seen there is
/// fluid, and a film goes on around it; that elsewhere is none cannot be told, as a mirror image needs the
/// right angle. The mask takes the way through the lens that the picture took.
cv::Mat1f filmAround(const Image& photo, const PhotoPreparation& preparation) {
    const PixelMask mask = preparation.fillsHighlights()
                               ? highlightsOf(photo, preparation)
                               : highlightMask(shownOf(photo, preparation), usualSensitivity);
    Image drawn{photo.width, photo.height, std::vector<std::uint8_t>(photo.pixels.size(), 255)};
    for (std::size_t i = 0; i < mask.size(); ++i)
        std::fill_n(&drawn.pixels[4 * i], 3, mask[i]);
    PhotoPreparation lens;
    lens.lens = preparation.lens;
    if (preparation.lens) drawn = prepared(drawn, lens);
    const Image looked = shrunk(drawn, longestLookedAt);
    cv::Mat1f film(looked.height, looked.width);
    for (int y = 0; y < looked.height; ++y)
        for (int x = 0; x < looked.width; ++x)
            film(y, x) = static_cast<float>(looked.at(x, y)[0]) / 255;
    cv::Mat1f spread = blurred(film, std::max(1.0, filmSpread * diagonalOf(looked)));
    for (float& value : spread)
        value = std::min(1.0F, strengthened * value);
    return spread;
}

/// Values of every pixel of the picture from those of the smaller one that was looked at.
template<typename Rounding>
cv::Mat1b inSizeOf(const Image& picture, const cv::Mat1f& values, const Rounding& rounding) {
    cv::Mat1b bytes(values.size());
    std::transform(values.begin(), values.end(), bytes.begin(), rounding);
    if (bytes.cols != picture.width || bytes.rows != picture.height)
        cv::resize(bytes, bytes, {picture.width, picture.height}, 0, 0, cv::INTER_LINEAR);
    return bytes;
}

float brightnessOf(const std::uint8_t* pixel) {
    return 0.2126F * pixel[0] + 0.7152F * pixel[1] + 0.0722F * pixel[2];
}

/// How much brighter each pixel is than its surroundings, as a share of their brightness; 0 without alpha.
/// What is transparent takes no part in its surroundings.
cv::Mat1f detailOf(const Image& shown) {
    cv::Mat1f brightness(shown.height, shown.width), counts(shown.height, shown.width);
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x) {
            const std::uint8_t* pixel = shown.at(x, y);
            counts(y, x) = static_cast<float>(pixel[3]) / 255;
            brightness(y, x) = counts(y, x) * brightnessOf(pixel);
        }
    const auto meanOver = [&](double width) {
        cv::Mat1f mean;
        cv::divide(blurred(brightness, width), cv::max(blurred(counts, width), 1e-3), mean);
        return mean;
    };
    const cv::Mat1f around = meanOver(std::max(2 * noiseWidth, detailWidth * diagonalOf(shown)));
    cv::Mat1f detail;
    cv::divide(meanOver(noiseWidth) - around, around + darkestSurround, detail);
    std::transform(detail.begin(), detail.end(), around.begin(), detail.begin(),
                   [](float brighter, float surround) {
                       return brighter * static_cast<float>(smoothStep(allNoise, littleNoise, surround));
                   });
    cv::multiply(detail, counts, detail);
    return detail;
}

/// Whether brightness varies in a square of the picture by more than noise does.
bool hasDetailIn(const Image& shown, int left, int top, int width) {
    float darkest = 255, brightest = 0;
    for (int y = top; y < std::min(top + width, shown.height); ++y)
        for (int x = left; x < std::min(left + width, shown.width); ++x) {
            if (shown.at(x, y)[3] == 0) continue;
            const float brightness = brightnessOf(shown.at(x, y));
            darkest = std::min(darkest, brightness);
            brightest = std::max(brightest, brightness);
        }
    return brightest - darkest > leastDetail * (brightest + darkestSurround);
}

} // namespace

FinishColour finishColour(const SurfaceFinish& finish) {
    return {byteOf(finish.wetness), byteOf(finish.roughness), noHeight};
}

std::vector<std::uint8_t> filmOf(const Image& photo, const PhotoPreparation& preparation) {
    const cv::Mat1b film = inSizeOf(photo, filmAround(photo, preparation), byteOf);
    return {film.begin(), film.end()};
}

std::vector<std::int8_t> heightsOf(const Image& shown) {
    const cv::Mat1b bytes = inSizeOf(shown, detailOf(shrunk(shown, longestLookedAt)), [](float brighter) {
        const float height = std::clamp(heightAtHalf * brighter, -1.0F, 1.0F);
        return static_cast<std::uint8_t>(noHeight + std::lround(heightSteps * height));
    });
    std::vector<std::int8_t> heights(bytes.total());
    std::transform(bytes.begin(), bytes.end(), heights.begin(),
                   [](std::uint8_t byte) { return static_cast<std::int8_t>(byte - noHeight); });
    return heights;
}

Image finishPicture(const Image& shown, const FilmAndHeights& found, const LayerFinish& finish,
                    double greatestHeight) {
    Image picture{shown.width, shown.height, std::vector<std::uint8_t>(shown.pixels.size())};
    const SurfaceFinish& own = finish.surface;
    const double filmScale = finish.wetAtHighlights / 255;
    const double heightScale = finish.relief > 0 ? finish.relief / greatestHeight : 0;
    for (std::size_t i = 0; i < shown.pixels.size() / 4; ++i) {
        const double wet = filmScale > 0 ? filmScale * (*found.film)[i] : 0;
        const double height = heightScale > 0 ? heightScale * (*found.heights)[i] : 0;
        std::uint8_t* pixel = &picture.pixels[4 * i];
        pixel[0] = byteOf(own.wetness + (1 - own.wetness) * wet);
        pixel[1] = byteOf(own.roughness * (1 - smoothUnderFilm * wet));
        pixel[2] = static_cast<std::uint8_t>(noHeight + std::lround(height));
        pixel[3] = shown.pixels[4 * i + 3];
    }
    return picture;
}

/// Asked of squares as wide as what counts as detail, until one has some: most photos show it in the first.
bool hasDetail(const Image& shown) {
    const int width = std::max(4, static_cast<int>(detailWidth * diagonalOf(shown)));
    for (int top = 0; top < shown.height; top += width)
        for (int left = 0; left < shown.width; left += width)
            if (hasDetailIn(shown, left, top, width)) return true;
    return false;
}

} // namespace esm
