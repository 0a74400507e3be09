#pragma once

namespace esm {

/// Width and height of a photo, pixels.
struct PhotoSize {
    int width, height;

    double aspect() const { return static_cast<double>(width) / height; }

    bool operator==(const PhotoSize&) const = default;
};

/// A pinhole camera in photo pixels: focal lengths, and the principal point from the photo's top left corner.
struct Intrinsics {
    double fx, fy; ///< > 0
    double cx, cy;

    bool operator==(const Intrinsics&) const = default;
};

} // namespace esm
