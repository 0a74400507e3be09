#pragma once

#include "core/project/project.h"

namespace esm {

/// Every number bit by bit. Differences are failures of the running test.
void expectSameProject(const Project& a, const Project& b);
void expectSameRegions(const std::vector<Region>& a, const std::vector<Region>& b);
void expectSameStiffening(const std::optional<SpringStiffening>& a, const std::optional<SpringStiffening>& b);
void expectSameStepping(const std::optional<MeasuredStepping>& a, const std::optional<MeasuredStepping>& b);

} // namespace esm
