#pragma once

#include <functional>

namespace esm {

/// Largest h ≥ `stable`, up to `cap`, for which `holds`, which is true below some step and false above it;
/// short of it by at most the tolerance, relative.
double largestHolding(double stable, double cap, double tolerance, const std::function<bool(double)>& holds);

} // namespace esm
