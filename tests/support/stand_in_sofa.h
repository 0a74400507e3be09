#pragma once

#include "core/project/project.h"
#include "tests/support/with_variable.h"

#include <filesystem>
#include <string>

namespace esm::test {

/// The program that stands in for runSofa: in it nodes fall freely.
inline std::filesystem::path standInSofa() {
    return std::filesystem::path(ESM_SOURCE_DIR) / "tests/core/exchange/simulators/sofa/stand_in_sofa.py";
}

/// Nothing holds the organ, and it falls for a tenth of a second: half of g·t² is 49.05 mm.
inline Project falling(Project project) {
    project.scene = {};
    project.scene.duration = 0.1;
    project.scene.gravity = {0, -9.81, 0};
    return project;
}
inline constexpr double fallenBy = 0.04905; ///< m

} // namespace esm::test
