#pragma once

#include "core/support/words.h"

#include <array>

namespace esm {

/// How the nodes that fill a body are laid out, and which of them springs join. The spacing of a lattice is
/// the distance of nearest neighbours; its cube's edge a is 1, 2/√3 or 4/√3 of that.
enum class LatticeKind {
    Cubic,       ///< cubes with the diagonals of their faces, all of one constant: isotropic
    BodyCentred, ///< 8 neighbours of constant c and 6 of 2/3 c: isotropic
    Diamond,     ///< 4 neighbours and 12 second ones of one constant [R 3.3.1.2]
    BareDiamond, ///< the source's: 4 neighbours alone [R algorithm 3.3]. Floppy: it resists no shear
};
template<>
inline constexpr auto wordsOf<LatticeKind> =
    std::array{Word{LatticeKind::Cubic, "cubic"}, Word{LatticeKind::BodyCentred, "body-centred"},
               Word{LatticeKind::Diamond, "diamond"}, Word{LatticeKind::BareDiamond, "bare-diamond"}};

} // namespace esm
