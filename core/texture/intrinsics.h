#pragma once

namespace esm {

/// Width and height of a photo, pixels.
struct PhotoSize {
    int width, height;

    double aspect() const { return static_cast<double>(width) / height; }
};

/// A pinhole camera in photo pixels: focal lengths, and the principal point from the photo's top left corner.
struct Intrinsics {
    double fx, fy; ///< > 0
    double cx, cy;

    bool operator==(const Intrinsics& other) const {
        return fx == other.fx && fy == other.fy && cx == other.cx && cy == other.cy;
    }
};

} // namespace esm
