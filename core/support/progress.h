#pragma once

#include "core/support/errors.h"

#include <functional>

namespace esm {

/// Called now and then by long work with the fraction done, 0 to 1, below 0 where that is not known.
/// Returning false cancels the work. May be empty. Called on the thread that does the work.
using Progress = std::function<bool(double fraction)>;

/// Reports to `progress` if there is one. @throws Cancelled when it asks to stop.
inline void reportProgress(const Progress& progress, double fraction) {
    if (progress && !progress(fraction)) throw Cancelled();
}

} // namespace esm
