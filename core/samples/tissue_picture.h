#pragma once

#include "core/support/smooth_step.h"
#include "core/texture/image.h"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace esm {

using TissueColour = Eigen::Vector3d; ///< sRGB, 0 to 1

constexpr int pictureSize = 512;

/// One value per pixel of a sample picture.
struct Field {
    std::vector<double> values = std::vector<double>(std::size_t{pictureSize} * pictureSize);

    double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * pictureSize + static_cast<std::size_t>(x)];
    }
    double at(int x, int y) const { return const_cast<Field*>(this)->at(x, y); }
};

/// What a picture is made of: colour and alpha by place (0 to 1 across the picture), and how bumpy and wet it
/// is.
struct Tissue {
    std::function<TissueColour(double x, double y)> colour;
    std::function<double(double x, double y)> alpha;
    Field height; ///< pixels
    double gloss = 0.5;
};

Image pictureOf(const Tissue& tissue);

/// The field's value at a place of 0 to 1 across the picture.
double valueAt(const Field& field, double x, double y);

TissueColour mixed(const TissueColour& a, const TissueColour& b, double share);

/// Layered noise of that height (pixels).
Field bumps(double featuresAcross, int octaves, double height, std::uint32_t seed);

/// Darker and paler patches of several sizes.
TissueColour mottled(const TissueColour& dark, const TissueColour& pale, double x, double y,
                     std::uint32_t seed);

} // namespace esm
