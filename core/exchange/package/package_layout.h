#pragma once

/// What writing and reading of the model package agree on; described in `docs/model-package.md`.
namespace esm::package_layout {

constexpr const char* extension = "ESM_spring_mass";
constexpr const char* units = "SI: metre, kilogram, second, newton";

/// A spring's parameters are its ends' mean; how far 32-bit rounding may lead from it, relative.
constexpr double meanTolerance = 1e-6;

/// Pixels, width and height of the preview picture.
constexpr int largestPreview = 4096;

} // namespace esm::package_layout
