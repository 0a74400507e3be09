#include "core/texture/layers/blending.h"

namespace esm {

namespace {

/// As the specification has it, of sRGB values.
float luminosity(const Eigen::Array3f& colour) {
    return 0.3F * colour.x() + 0.59F * colour.y() + 0.11F * colour.z();
}

/// ClipColor of the specification: towards the grey of the same luminosity, as far as needed.
Eigen::Array3f clipped(Eigen::Array3f colour) {
    const float grey = luminosity(colour), least = colour.minCoeff(), most = colour.maxCoeff();
    if (least < 0) colour = grey + (colour - grey) * (grey / (grey - least));
    if (most > 1) colour = grey + (colour - grey) * ((1 - grey) / (most - grey));
    return colour;
}

/// SetLum of the specification.
Eigen::Array3f withLuminosity(const Eigen::Array3f& colour, float wanted) {
    return clipped(colour + (wanted - luminosity(colour)));
}

Eigen::Array3f overlaid(const Eigen::Array3f& beneath, const Eigen::Array3f& own) {
    const Eigen::Array3f product = 2 * beneath * own;
    return (beneath <= 0.5F).select(product, 2 * (beneath + own) - product - 1);
}

} // namespace

Eigen::Array3f blended(Blending blending, const Eigen::Array3f& beneath, const Eigen::Array3f& own) {
    switch (blending) {
    case Blending::Multiply:
        return beneath * own;
    case Blending::Screen:
        return beneath + own - beneath * own;
    case Blending::Overlay:
        return overlaid(beneath, own);
    case Blending::Colour:
        return withLuminosity(own, luminosity(beneath));
    case Blending::Normal:
    case Blending::MultiBand:
        break;
    }
    return own;
}

} // namespace esm
