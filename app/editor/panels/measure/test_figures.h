#pragma once

#include "app/editor/panels/measure/press_figures.h"

namespace esm {

/// The numbers that one kind of test tells.
std::vector<PressFigure> testFigures(TestKind kind);

} // namespace esm
