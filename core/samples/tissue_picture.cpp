#include "core/samples/tissue_picture.h"

#include "core/samples/noise.h"
#include "core/support/smooth_step.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// The normal of a height field is (−∂h/∂x, −∂h/∂y, 1); by differences over two pixels, hence the 2.
Eigen::Vector3d normalAt(const Field& height, int x, int y) {
    const int left = std::max(x - 1, 0), right = std::min(x + 1, pictureSize - 1);
    const int above = std::max(y - 1, 0), below = std::min(y + 1, pictureSize - 1);
    return Eigen::Vector3d(height.at(left, y) - height.at(right, y),
                           height.at(x, above) - height.at(x, below), 2)
        .normalized();
}

/// An endoscope's light comes from the eye: bright where the surface faces it, with small sharp reflections.
TissueColour lit(const TissueColour& colour, const Eigen::Vector3d& normal, double gloss) {
    static const Eigen::Vector3d light = Eigen::Vector3d(-0.25, -0.35, 1).normalized();
    const double facing = std::max(0.0, normal.dot(light));
    const double sheen = 0.25 * gloss * smoothStep(0.93, 1, facing);
    const double reflection = gloss * smoothStep(0.9965, 0.9993, facing);
    // light that has passed through tissue fills shadows with red
    const TissueColour shade =
        TissueColour(0.75, 0.58, 0.58) + facing * facing * TissueColour(0.27, 0.44, 0.44);
    return mixed(colour.cwiseProduct(shade), TissueColour(1, 0.97, 0.94), std::max(sheen, reflection));
}

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

} // namespace

Image pictureOf(const Tissue& tissue) {
    Image image;
    image.width = image.height = pictureSize;
    image.pixels.reserve(std::size_t{4} * pictureSize * pictureSize);
    for (int y = 0; y < pictureSize; ++y) {
        for (int x = 0; x < pictureSize; ++x) {
            const double u = (x + 0.5) / pictureSize, v = (y + 0.5) / pictureSize;
            const TissueColour colour = lit(tissue.colour(u, v), normalAt(tissue.height, x, y), tissue.gloss);
            for (const double channel : {colour.x(), colour.y(), colour.z(), tissue.alpha(u, v)})
                image.pixels.push_back(byte(channel));
        }
    }
    return image;
}

double valueAt(const Field& field, double x, double y) {
    return field.at(static_cast<int>(x * pictureSize), static_cast<int>(y * pictureSize));
}

TissueColour mixed(const TissueColour& a, const TissueColour& b, double share) {
    return a + std::clamp(share, 0.0, 1.0) * (b - a);
}

Field bumps(double featuresAcross, int octaves, double height, std::uint32_t seed) {
    Field field;
    for (int y = 0; y < pictureSize; ++y)
        for (int x = 0; x < pictureSize; ++x)
            field.at(x, y) = height * layeredNoise(featuresAcross * x / pictureSize,
                                                   featuresAcross * y / pictureSize, octaves, seed);
    return field;
}

TissueColour mottled(const TissueColour& dark, const TissueColour& pale, double x, double y,
                     std::uint32_t seed) {
    const double wide = layeredNoise(4 * x, 4 * y, 4, seed),
                 fine = layeredNoise(30 * x, 30 * y, 3, seed + 50);
    return mixed(dark, pale, 0.5 + 1.5 * (wide - 0.5) + 0.5 * (fine - 0.5));
}

} // namespace esm
