#pragma once

#include "core/support/progress.h"
#include "core/texture/image.h"
#include "core/texture/intrinsics.h"

#include <Eigen/Geometry>

#include <array>

namespace esm {

enum class LensKind { Pinhole, Fisheye };
template<>
inline constexpr auto wordsOf<LensKind> =
    std::array{Word{LensKind::Pinhole, "pinhole"}, Word{LensKind::Fisheye, "fisheye"}};

/// How a lens bends straight lines, in OpenCV's models.
struct Lens {
    LensKind kind = LensKind::Pinhole;
    Intrinsics camera;
    std::array<double, 5> coefficients{}; ///< k1 k2 p1 p2 k3; of a fisheye k1 k2 k3 k4, and 0

    bool operator==(const Lens&) const = default;
};
template<>
inline constexpr auto fieldsOf<Lens> = fieldTable(field("kind", &Lens::kind), fieldsOfMember(&Lens::camera),
                                                  field("coefficients", &Lens::coefficients,
                                                        Limits<double>{"the coefficients", -1000, 1000}));

/// OpenCV knows five of a pinhole and four of a fisheye.
constexpr std::size_t coefficientsOf(LensKind kind) {
    return kind == LensKind::Fisheye ? 4 : 5;
}

/// Where the photo shows what a lens without distortion would show at `place`.
Eigen::Vector2d distorted(const Lens& lens, const Eigen::Vector2d& place);

/// The photo as a lens without distortion would have taken it, of the same size; alpha 0 where it has
/// nothing. @throws Cancelled
Image undistorted(const Image& photo, const Lens& lens, const Progress& progress = {});

} // namespace esm
