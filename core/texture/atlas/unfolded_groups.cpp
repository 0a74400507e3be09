#include "core/texture/atlas/unfolded_groups.h"

#include <algorithm>

namespace esm {

namespace {

/// The scale for which groups are unfolded lies below the one that is asked for, since the search for the
/// largest goes up and down a little. Unfolding for a smaller scale keeps triangles farther apart in metres
/// than a larger one needs: it costs some groups their size, but never the gap.
constexpr double margin = 0.9;

} // namespace

PatchLayout UnfoldedGroups::layoutAt(double texelsPerMetre, const PageRoom& page, int mostPages,
                                     const Progress& progress) {
    ProgressParts parts(progress);
    if (texelsPerMetre < m_smallestScale) unfoldFor(margin * texelsPerMetre, page.gap, parts.next(0.6));
    return layoutGroups(m_groups, texelsPerMetre, page, mostPages, parts.rest());
}

void UnfoldedGroups::unfoldFor(double texelsPerMetre, double gap, const Progress& progress) {
    ProgressParts parts(progress);
    m_smallestScale = texelsPerMetre;
    std::vector<std::pair<TurnedGroup, std::vector<std::uint32_t>>> groups;
    std::vector<UnfoldedGroup> unfolded = unfold(m_mesh, m_shapes, gap / texelsPerMetre, parts.next(0.8));
    const Progress turning = parts.rest();
    for (UnfoldedGroup& group : unfolded) {
        reportStep(turning, groups.size(), unfolded.size());
        groups.emplace_back(turned(group), std::move(group.triangles));
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto& a, const auto& b) { return a.first.height > b.first.height; });
    m_groups.clear();
    m_order.clear();
    for (auto& [group, triangles] : groups) {
        m_groups.push_back(std::move(group));
        for (const std::uint32_t triangle : triangles) {
            m_order.push_back(m_shapes[triangle]);
            m_order.back().firstCorner = 0;
        }
    }
}

} // namespace esm
