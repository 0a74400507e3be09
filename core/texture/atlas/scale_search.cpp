#include "core/texture/atlas/scale_search.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Part of the bound that layouts come to on most organs, where the search begins.
constexpr double usualShare = 0.8;

/// Looks between the largest scale that fits and the smallest that does not.
class Search {
public:
    Search(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range,
           const Progress& progress)
        : m_layoutAt(layoutAt), m_options(options), m_attempts(progress), m_smallest(range.smallest),
          m_failing(range.bound),
          m_available((options.size - options.gap) * static_cast<double>(options.pages)) {}

    /// [R 4.9] begins at the scale at which the patches would fill the pages without any waste, [R 4.10] goes
    /// down by how much too high the rows came. That factor tends to 1 as the height nears the page's, and
    /// the source's loop with it to a standstill: each step therefore goes down by at least 0.5 % (an excess
    /// of 0.05 in [R 4.10]). What fits then lies up to a step too low, which the bisection makes good.
    ScaledLayout bySource() {
        for (double scale = m_failing; scale > m_smallest && m_best.scale == 0;) {
            const double height = attempt(scale);
            scale *=
                std::sqrt(1 / (1 + std::max(height - m_available, 0.05 * m_available) / (5 * m_available)));
        }
        if (m_best.scale == 0) attempt(m_smallest);
        while (m_best.scale > 0 && m_failing > m_best.scale * 1.0005)
            attempt((m_best.scale + m_failing) / 2);
        return std::move(m_best);
    }

    /// A layout of the same quality takes a height that grows with the square of the scale, so one attempt
    /// tells nearly where the answer lies: regula falsi with a model instead of a chord. Packings jump,
    /// however: one patch more in a row, and the next row begins elsewhere. Whatever the guess, the answer
    /// stays between a scale that fitted and one that failed.
    ScaledLayout byHeight() {
        constexpr double precision = 0.001;
        double scale = std::max(m_smallest, usualShare * m_failing);
        while (!(m_best.scale > 0 && m_failing <= m_best.scale * (1 + precision))) {
            const double height = attempt(scale);
            if (m_failing <= m_smallest) break;
            scale = next(scale, height);
        }
        return std::move(m_best);
    }

private:
    /// Pixels that the layout takes.
    double attempt(double scale) {
        PatchLayout layout = m_layoutAt(m_options, scale, m_attempts.nextOfRest(shareOfAttempt));
        const double height = layout.height;
        if (fits(layout, m_options))
            m_best = {scale, std::move(layout)};
        else
            m_failing = scale;
        return height;
    }

    /// The guess is put a little beyond where the height would be just right: above it after a layout that
    /// fitted, below it after one that did not. A guess that is right to within 0.05 % then moves the other
    /// end of the interval, and the search is over. Without this it would come near from one side, again and
    /// again, and the other end would stay where it was.
    ///
    /// As long as nothing has fitted there is no interval yet. Then the scale goes down by 2 % at least, so
    /// that the search ends however badly a height is estimated.
    double next(double scale, double height) const {
        constexpr double beyond = 0.0005, leastStep = 0.02;
        const bool fitted = m_best.scale == scale;
        const double ratio = height > 0 ? std::sqrt(m_available / height) : 0;
        const double guess = scale * ratio * (fitted ? 1 + beyond : 1 - beyond);
        if (m_best.scale == 0) return std::max(m_smallest, std::min(guess, (1 - leastStep) * m_failing));
        return guess > m_best.scale && guess < m_failing ? guess : (m_best.scale + m_failing) / 2;
    }

    const LayoutAt& m_layoutAt;
    AtlasOptions m_options;
    ProgressParts m_attempts;
    double m_smallest, m_failing; ///< texels per m
    double m_available;           ///< pixels of height
    ScaledLayout m_best;
};

} // namespace

bool fits(const PatchLayout& layout, const AtlasOptions& options) {
    return layout.pages > 0 && layout.pages <= options.pages;
}

ScaledLayout largestBySource(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range,
                             const Progress& progress) {
    return Search(layoutAt, options, range, progress).bySource();
}

ScaledLayout largestByHeight(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range,
                             const Progress& progress) {
    return Search(layoutAt, options, range, progress).byHeight();
}

} // namespace esm
