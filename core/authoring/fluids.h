#pragma once

#include "core/project/project.h"
#include "core/support/progress.h"

#include <optional>
#include <string>
#include <vector>

namespace esm {

/// A connected part of the organ's simulated surface, which a fluid fills, could fill or cannot.
struct FillablePart {
    std::uint32_t part = 0; ///< as of a filling
    double volume = 0;      ///< m³ at rest; 0 where no fluid can be in it
    /// Why no fluid can be in it, as what is said of the part: " is open, …". Empty when one can.
    std::string problem;
};

/// All of them, in order. @throws Cancelled
std::vector<FillablePart> fillableParts(const TriangleMesh& mesh, const SpringNetwork& network,
                                        const Progress& progress = {});

/// Why no part of the organ can hold a fluid, whatever its surface: a sentence without a full stop. Empty
/// when parts may.
std::string whyNoFluid(const Project& project);

/// Pa, with which a fluid keeps its volume within a thousandth, whatever a wall of such springs, N/m, around
/// such a volume, m³, bears. 1, 2 or 5 times a power of ten.
double usualFluidStiffness(double springConstant, double volume);

/// Fills a part with a fluid of this stiffness, Pa, in place of one that is there; without takes it out.
void fillPart(Project& project, std::uint32_t part, std::optional<double> stiffness);

/// Lets one pressure, Pa, act in a part from the beginning on, in place of what acts there; 0: none.
void pressPart(Project& project, std::uint32_t part, double pressure);

} // namespace esm
