#pragma once

#include "app/editor/workers/poke_motion.h"
#include "core/exchange/charts/drawing.h"

namespace esm {

/// A motion under the name that charts and tables call it by.
struct NamedMotion {
    std::string name; ///< ASCII
    std::shared_ptr<const PokeMotion> motion;
};

/// Force (N) over time (s).
Drawing pokeChart(const std::vector<NamedMotion>& motions);

/// A line for each picture of each motion, under a line of names: name, time (s), force (N), displacement
/// (m).
std::string pokeCsv(const std::vector<NamedMotion>& motions);

} // namespace esm
