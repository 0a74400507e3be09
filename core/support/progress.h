#pragma once

#include "core/support/errors.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace esm {

/// Called now and then by long work with the fraction done, from 0 to 1, which never falls and ends at 1.
/// Returning false cancels the work. May be empty. Called on the thread that asked for the work.
using Progress = std::function<bool(double fraction)>;

/// Reports to `progress` if there is one. @throws Cancelled when it asks to stop.
inline void reportProgress(const Progress& progress, double fraction) {
    if (progress && !progress(fraction)) throw Cancelled();
}

/// Reports that so many of many small steps are done, one time in a thousand. @throws Cancelled
inline void reportStep(const Progress& progress, std::size_t done, std::size_t steps) {
    constexpr std::size_t every = 1024;
    if (done % every == 0) reportProgress(progress, static_cast<double>(done) / static_cast<double>(steps));
}

/// Lays the parts of a work onto its progress, one behind the other: each part reports its own 0 to 1, and
/// the whole never goes back. A part is done with once the next is taken.
class ProgressParts {
public:
    explicit ProgressParts(Progress whole) : m_whole(std::move(whole)) {}

    /// Of the next part, which takes such a share of the whole. Empty where the whole's is.
    Progress next(double share) {
        const double from = m_taken;
        m_taken = std::min(1.0, from + share);
        if (!m_whole) return {};
        return [whole = m_whole, from, to = m_taken](double fraction) {
            return whole(from + (to - from) * std::clamp(fraction, 0.0, 1.0));
        };
    }
    /// Of the next part, where it is not known how many more there will be: a share of what is left.
    Progress nextOfRest(double share) { return next(share * (1 - m_taken)); }
    /// Of the last part.
    Progress rest() { return nextOfRest(1); }

private:
    Progress m_whole;
    double m_taken = 0;
};

} // namespace esm
