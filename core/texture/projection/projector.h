#pragma once

#include "core/geometry/pose.h"
#include "core/support/fields.h"
#include "core/texture/intrinsics.h"
#include "core/texture/texture_limits.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <optional>

namespace esm {

enum class ProjectorKind {
    Parallel,    ///< the photo lies in the plane z = 0, centred on the origin, and is projected along −z
    Perspective, ///< from an eye at the origin that looks along −z, as the camera saw it
};
template<>
inline constexpr auto wordsOf<ProjectorKind> =
    std::array{Word{ProjectorKind::Parallel, "parallel"}, Word{ProjectorKind::Perspective, "perspective"}};

/// From where a photo is projected, x right and y up in its own space [R 4.3.2.3].
struct Projector {
    Pose pose = Pose::Identity();     ///< projector → model, m
    double width = 0.1, height = 0.1; ///< parallel: of the photo in space, m, > 0
    bool occlusion = true;            ///< colour only what the projector sees: not hidden, and facing it
    ProjectorKind kind = ProjectorKind::Parallel;
    double fieldOfView = 40;              ///< perspective: vertical, degrees, as a file says it
    std::optional<Intrinsics> intrinsics; ///< perspective: in place of the field of view
    bool areIntrinsicsFound = false;      ///< by landmarks: with others they are sought anew
    bool falloff = false;                 ///< the weight falls with the angle, see `angleWeight`

    bool isParallel() const { return kind == ProjectorKind::Parallel; }
    bool hasIntrinsics() const { return !isParallel() && intrinsics; }

    bool operator==(const Projector&) const = default;
};
template<>
inline constexpr auto fieldsOf<Projector> = [] {
    using namespace texture_limits;
    const auto isParallel = [](const Projector& projector) { return projector.isParallel(); };
    return fieldTable(
        field("pose", &Projector::pose),
        field("width", &Projector::width,
              Limits<double>{"the projector's width", shortestPhoto, longestPhoto, "m"})
            .onlyWhere(isParallel),
        field("height", &Projector::height,
              Limits<double>{"the projector's height", shortestPhoto, longestPhoto, "m"})
            .onlyWhere(isParallel),
        field("kind", &Projector::kind).mayBeAbsent(),
        field("intrinsics", &Projector::intrinsics).onlyWhere([](const Projector& projector) {
            return projector.hasIntrinsics();
        }),
        field("intrinsicsFound", &Projector::areIntrinsicsFound).whenSet(),
        field("fov", &Projector::fieldOfView,
              Limits<double>{"the projector's field of view", narrowestView, widestView, "degrees"})
            .onlyWhere(
                [](const Projector& projector) { return !projector.isParallel() && !projector.intrinsics; }),
        field("occlusion", &Projector::occlusion).mayBeAbsent(),
        field("falloff", &Projector::falloff).whenSet());
}();

/// The camera of a perspective projector; from a field of view one with square pixels and the principal point
/// in the photo's middle.
Intrinsics intrinsicsOf(const Projector& projector, PhotoSize photo);

/// The photo's corners in space, m: bottom left, bottom right, top right, top left; of a perspective
/// projector so far before the eye, of a parallel one behind its plane.
std::array<Eigen::Vector3d, 4> photoCorners(const Projector& projector, PhotoSize photo, double depth);

/// Takes a point of the model (x, y, z, 1; m) to the photo: the first three rows give (x·w, y·w, w) of its
/// place in pixels from the top left corner, a pixel's centre at 0.5; the last its depth in front of the
/// photo's plane or the eye (m). Where w ≤ 0 the projector sees nothing.
Eigen::Matrix4d photoMatrix(const Projector& projector, PhotoSize photo);

/// A point's place in the photo, pixels, and its depth (m), below 0 behind the plane of a parallel projector.
/// Nothing for a point that is not before the eye of a perspective one.
std::optional<Eigen::Vector3d> project(const Projector& projector, PhotoSize photo,
                                       const Eigen::Vector3d& point);

/// The share that surface takes at an angle to the light, by the cosine between its normal and the way to the
/// projector: all up to 60°, nothing from 85° on, smoothly between (3t² − 2t³ of the angle). From either
/// side.
double angleWeight(double cosine);

} // namespace esm
