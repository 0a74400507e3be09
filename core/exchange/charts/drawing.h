#pragma once

#include "core/texture/image.h"

#include <array>
#include <string>
#include <vector>

namespace esm {

/// Lines, dots and words on white, for charts: the same as text (SVG) and as pixels. Places are in pixels
/// from the upper left corner.
struct Drawing {
    struct Place {
        double x, y;
    };
    using Colour = std::array<int, 3>; ///< red, green, blue, 0 to 255

    struct Line {
        Place from, to;
        Colour colour;
        int width = 1;
    };
    struct Dot {
        Place centre;
        double radius;
        Colour colour;
        bool filled = true;
    };
    enum class Anchor { Start, Middle, End };
    struct Label {
        Place place;      ///< of the text's baseline
        std::string text; ///< ASCII
        Anchor anchor = Anchor::Start;
    };

    int width, height;
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<Label> labels;
};

std::string toSvg(const Drawing& drawing);
Image toImage(const Drawing& drawing);

} // namespace esm
