#pragma once

#include "core/support/progress.h"

#include <atomic>
#include <functional>

namespace esm {

/// Progress of work beside the window that keeps what is done where the window reads it, and tells the window
/// at every hundredth. Work that is not to go on changes nothing more: the bar is another's by then.
inline Progress toldProgress(const Progress& goesOn, std::atomic<double>& done,
                             const std::function<void()>& tell) {
    constexpr double step = 0.01;
    return [goesOn, &done, tell, said = 0.0](double fraction) mutable {
        if (!goesOn(fraction)) return false;
        if (fraction >= said + step) {
            said = fraction;
            done = fraction;
            tell();
        }
        return true;
    };
}

} // namespace esm
