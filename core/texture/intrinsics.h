#pragma once

#include "core/support/fields.h"
#include "core/texture/image.h"
#include "core/texture/texture_limits.h"

namespace esm {

/// Width and height of a photo, pixels.
struct PhotoSize {
    int width, height;

    double aspect() const { return static_cast<double>(width) / height; }

    bool operator==(const PhotoSize&) const = default;
};

inline PhotoSize sizeOf(const Image& photo) {
    return {photo.width, photo.height};
}

/// A pinhole camera in photo pixels: focal lengths, and the principal point from the photo's top left corner.
struct Intrinsics {
    double fx = 1, fy = 1; ///< > 0
    double cx = 0, cy = 0;

    bool operator==(const Intrinsics&) const = default;
};
template<>
inline constexpr auto fieldsOf<Intrinsics> = [] {
    constexpr double most = texture_limits::longestFocalLength;
    return fieldTable(
        field("fx", &Intrinsics::fx, positiveLimits("the focal length fx", "pixels", most)),
        field("fy", &Intrinsics::fy, positiveLimits("the focal length fy", "pixels", most)),
        field("cx", &Intrinsics::cx, Limits<double>{"the principal point's cx", -most, most, "pixels"}),
        field("cy", &Intrinsics::cy, Limits<double>{"the principal point's cy", -most, most, "pixels"}));
}();

} // namespace esm
