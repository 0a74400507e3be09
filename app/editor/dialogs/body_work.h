#pragma once

namespace esm {

/// The time of a step by `split2`, over that of a hollow organ that bends freely and has as many nodes
/// (docs/performance.md).
inline constexpr double workOfBending = 2, workOfSolid = 1.5, workOfPrisms = 3;

} // namespace esm
