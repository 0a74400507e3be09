#pragma once

#include "core/model/cavity.h"
#include "core/model/scene.h"
#include "core/model/spring_network.h"

namespace esm {

/// The numbers of the parts that a scene fills or presses from within, rising.
std::vector<std::uint32_t> fluidParts(const Scene& scene);

/// Null where the scene has none of this part.
const FluidFilling* fluidOf(const Scene& scene, std::uint32_t part);
const PartPressure* pressureOf(const Scene& scene, std::uint32_t part);

/// All of them, and every pressure from within.
void removeFluids(Scene& scene);

/// Why what fills an organ leaves no room for a fluid; of a hollow one, nothing.
std::string whyNoRoom(const SpringNetwork& network);
/// What to do then.
inline constexpr auto adviceOnRoom =
    "make the organ hollow, of springs in its surface alone, or leave the fluid out";

/// The parts of a simulated surface that a scene fills or presses from within, each once, in the order in
/// which it names them: with the stiffness of their fluids, the largest pressure that acts on them and that
/// at time 0.
/// @throws InvalidModel under the scene's entry, where a part is none that holds a fluid: see cavityOf();
/// where `whyNoRoom()` says why
std::vector<Cavity> cavitiesOf(const Scene& scene, const SpringNetwork& network,
                               const std::vector<Triangle>& surface);

} // namespace esm
