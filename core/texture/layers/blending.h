#pragma once

#include "core/support/words.h"

#include <Eigen/Core>

#include <array>

namespace esm {

/// How a layer's colour mixes with what lies beneath, in sRGB values from 0 to 1. Modes that have a name in
/// *Compositing and Blending Level 1* (W3C 2015) are those there.
enum class Blending {
    Normal,    ///< hides it
    Multiply,  ///< darkens it: the product of both
    Screen,    ///< brightens it: the product of what both lack of white
    Overlay,   ///< darkens what is dark and brightens what is bright
    Colour,    ///< gives it hue and saturation, and leaves its luminosity
    MultiBand, ///< passes into it without a seam: coarse differences of colour over a wide border, details
               ///< over a narrow one; of photos only
};

inline constexpr std::array<Blending, 6> blendings{Blending::Normal, Blending::Multiply,
                                                   Blending::Screen, Blending::Overlay,
                                                   Blending::Colour, Blending::MultiBand};
template<>
inline constexpr auto wordsOf<Blending> =
    std::array{Word{Blending::Normal, "normal"}, Word{Blending::Multiply, "multiply"},
               Word{Blending::Screen, "screen"}, Word{Blending::Overlay, "overlay"},
               Word{Blending::Colour, "colour"}, Word{Blending::MultiBand, "multi-band"}};

/// Whether a layer that blends so, and is opaque, hides what lies beneath.
constexpr bool hides(Blending blending) {
    return blending == Blending::Normal || blending == Blending::MultiBand;
}

/// What a colour of full weight makes of the one beneath it, both red, green and blue from 0 to 1. A photo
/// that is blended in bands has been changed before.
Eigen::Array3f blended(Blending blending, const Eigen::Array3f& beneath, const Eigen::Array3f& own);

/// Whether what comes out is linear in what lies beneath, each channel by itself.
constexpr bool isLinear(Blending blending) {
    return blending != Blending::Overlay && blending != Blending::Colour;
}

} // namespace esm
