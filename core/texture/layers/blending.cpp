#include "core/texture/layers/blending.h"

namespace esm {

namespace {

/// As the specification has it, of sRGB values.
float luminosity(const Eigen::Array3f& colour) {
    return 0.3F * colour.x() + 0.59F * colour.y() + 0.11F * colour.z();
}

/// ClipColor of the specification: towards the grey of the same luminosity, as far as needed. What is grey
/// itself has no way to go, and is beyond the ends by rounding alone.
Eigen::Array3f clipped(Eigen::Array3f colour) {
    const float grey = luminosity(colour), below = grey - colour.minCoeff(), above = colour.maxCoeff() - grey;
    if (below > grey && below > 0) colour = grey + (colour - grey) * (grey / below);
    if (above > 1 - grey && above > 0) colour = grey + (colour - grey) * ((1 - grey) / above);
    return colour.max(0).min(1);
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
