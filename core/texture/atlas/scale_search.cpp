#include "core/texture/atlas/scale_search.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

/// Part of the bound that layouts come to on most organs, where the search begins.
constexpr double usualPart = 0.8;

/// Looks between the largest scale that fits and the smallest that does not.
class Search {
public:
    Search(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range)
        : m_layoutAt(layoutAt), m_options(options), m_smallest(range.smallest), m_failing(range.bound),
          m_available((options.size - options.gap) * static_cast<double>(options.pages)) {}

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

    ScaledLayout byHeight() {
        constexpr double precision = 0.001;
        double scale = std::max(m_smallest, usualPart * m_failing);
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
        PatchLayout layout = m_layoutAt(m_options, scale);
        const double height = layout.height;
        if (fits(layout, m_options))
            m_best = {scale, std::move(layout)};
        else
            m_failing = scale;
        return height;
    }

    /// A little beyond where the height would be just right, so that the interval closes from both sides.
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
    double m_smallest, m_failing; ///< texels per m
    double m_available;           ///< pixels of height
    ScaledLayout m_best;
};

} // namespace

bool fits(const PatchLayout& layout, const AtlasOptions& options) {
    return layout.pages > 0 && layout.pages <= options.pages;
}

ScaledLayout largestBySource(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range) {
    return Search(layoutAt, options, range).bySource();
}

ScaledLayout largestByHeight(const LayoutAt& layoutAt, const AtlasOptions& options, const ScaleRange& range) {
    return Search(layoutAt, options, range).byHeight();
}

} // namespace esm
