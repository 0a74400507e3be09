#pragma once

#include "core/model/spring_network.h"
#include "core/support/fields.h"

#include <array>
#include <optional>

namespace esm {

/// How much of what a drawn surface bounds is simulated.
struct Detail {
    enum class Kind {
        EveryVertex, ///< a node for every vertex
        Nodes,       ///< fewer nodes: a coarser surface that carries the drawn one
        Rigid,       ///< a few springs that move the whole as one stiff piece [R 5.1]
        Filled       ///< a lattice of nodes throughout the body [R 3.3.1]
    };
    Kind kind = Kind::EveryVertex;
    std::size_t nodes = 0; ///< wanted, where the kind is Nodes; else how many there are, or 0
    std::optional<LatticeFilling> filling{}; ///< where the kind is Filled
    bool isEven = false; ///< whether springs of a surface make an even sheet, see `SheetShares`

    bool operator==(const Detail&) const = default;
};
template<>
inline constexpr auto wordsOf<Detail::Kind> =
    std::array{Word{Detail::Kind::EveryVertex, "everyVertex"}, Word{Detail::Kind::Nodes, "nodes"},
               Word{Detail::Kind::Rigid, "rigid"}, Word{Detail::Kind::Filled, "filled"}};
template<>
inline constexpr auto fieldsOf<Detail> = fieldTable(field("kind", &Detail::kind),
                                                    field("nodes", &Detail::nodes),
                                                    field("filling", &Detail::filling).whenSet(),
                                                    field("evenSheet", &Detail::isEven).whenSet());

/// The level of detail that a network has, with the number of its nodes.
Detail detailOf(const SpringNetwork& network);

} // namespace esm
