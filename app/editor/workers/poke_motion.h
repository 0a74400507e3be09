#pragma once

#include "app/editor/workers/poke.h"
#include "core/project/project.h"
#include "core/support/progress.h"

#include <string>

namespace esm {

/// The organ at a moment of a poke.
struct PokePicture {
    double time;                            ///< s since rest
    std::vector<Eigen::Vector3f> positions; ///< m, of the nodes
    std::optional<PlacedCollider> instrument;
    double force = 0;        ///< N, of the tissue on what pokes it, a mean over a moment
    double displacement = 0; ///< m, of the tissue there, from rest
};

/// How an organ moves under a poke.
struct PokeMotion {
    Project project;                   ///< of the organ, as it was then
    std::vector<PokePicture> pictures; ///< at even times, from rest on
    std::string failure;               ///< why it ends before the poke does; empty where it does not
};

inline constexpr int pokePicturesPerSecond = 30;

/// Steps the project as the window does, in its own time. @throws InvalidModel where it cannot be simulated
/// @throws Cancelled
PokeMotion motionUnder(const Poke& poke, const Project& project, const Progress& progress = {});

/// The number of the last picture at or before a time, s.
int pictureNumberAt(double time);
/// The same of a motion; the last one where it ends before. Precondition: it has some.
const PokePicture& pictureAt(const PokeMotion& motion, double time);

std::vector<Eigen::Vector3d> inDoubles(const std::vector<Eigen::Vector3f>& positions);

} // namespace esm
