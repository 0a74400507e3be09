#include "core/texture/row_layout.h"

#include "core/texture/reach.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double leftEnd(const PatchCorners& corners) {
    return std::min({corners[0].x(), corners[1].x(), corners[2].x()});
}

double rightEnd(const PatchCorners& corners) {
    return std::max({corners[0].x(), corners[1].x(), corners[2].x()});
}

/// The patch in a row whose upper border is y = 0, not yet shifted to its place.
PatchCorners cornersInRow(const PatchShape& shape, double scale, double rowHeight, bool pointsUp) {
    const double base = scale * shape.base, foot = scale * shape.foot, height = scale * shape.height;
    if (pointsUp) return {{{0, rowHeight}, {base, rowHeight}, {foot, rowHeight - height}}};
    return {{{base, 0}, {0, 0}, {base - foot, height}}};
}

void shift(PatchCorners& corners, double x, double y) {
    for (Eigen::Vector2d& corner : corners)
        corner += Eigen::Vector2d(x, y);
}

/// Patches of the row being filled. `reach[i]` is the right end of the first i + 1 patches: once that lies a
/// gap to the left of a new patch, no earlier patch can be near it.
struct Row {
    std::vector<PatchCorners> patches;
    std::vector<double> reach;

    double shiftFor(const PatchCorners& moving, double start, double gap) const {
        double result = start;
        const double left = leftEnd(moving);
        for (std::size_t i = patches.size(); i-- > 0 && reach[i] + gap > left + result;)
            result = std::max(result, clearingShift(patches[i], moving, gap));
        return result;
    }
    void add(const PatchCorners& corners) {
        reach.push_back(std::max(rightEnd(corners), reach.empty() ? -never : reach.back()));
        patches.push_back(corners);
    }
    void clear() {
        patches.clear();
        reach.clear();
    }
};

class RowFiller {
public:
    RowFiller(const RowPage& page, double scale, std::size_t count)
        : m_scale(scale), m_gap(page.gap), m_border(page.gap / 2), m_end(page.size - page.gap / 2) {
        m_layout.corners.reserve(count);
        m_layout.page.reserve(count);
    }

    void place(const PatchShape& shape) {
        PatchCorners corners;
        if (m_row.patches.empty() || !fits(shape, corners)) {
            startRow(m_scale * shape.height);
            fits(shape, corners);
        }
        m_row.add(corners);
        m_pointsUp = !m_pointsUp;
        shift(corners, 0, m_y);
        m_layout.corners.push_back(corners);
        m_layout.page.push_back(static_cast<std::uint16_t>(std::min(m_page, 0xffff)));
    }

    RowLayout finish() {
        m_layout.pages = m_page + 1;
        m_layout.height = m_page * (m_end - m_border) + m_y + m_rowHeight - m_border;
        return std::move(m_layout);
    }

private:
    bool fits(const PatchShape& shape, PatchCorners& corners) const {
        corners = cornersInRow(shape, m_scale, m_rowHeight, m_pointsUp);
        shift(corners, m_row.shiftFor(corners, m_border, m_gap), 0);
        return rightEnd(corners) <= m_end;
    }

    void startRow(double height) {
        if (!m_row.patches.empty()) m_y += m_rowHeight + m_gap;
        if (m_y + height > m_end) {
            ++m_page;
            m_y = m_border;
        }
        m_rowHeight = height;
        m_pointsUp = true;
        m_row.clear();
    }

    double m_scale, m_gap, m_border, m_end;
    double m_y = m_border, m_rowHeight = 0;
    int m_page = 0;
    bool m_pointsUp = true;
    Row m_row;
    RowLayout m_layout;
};

} // namespace

double clearingShift(const PatchCorners& placed, const PatchCorners& moving, double gap) {
    double result = -never;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::size_t next = (edge + 1) % 3;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2d& v = placed[corner];
            const Eigen::Vector2d& w = moving[corner];
            result = std::max(result, v.x() - leftReach(moving[edge], moving[next], v.y(), gap));
            result = std::max(result, rightReach(placed[edge], placed[next], w.y(), gap) - w.x());
        }
    }
    return result;
}

RowLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page) {
    const double room = page.size - page.gap;
    for (const PatchShape& shape : shapes)
        if (std::max(shape.base, shape.height) * texelsPerMetre > room) return {};
    RowFiller filler(page, texelsPerMetre, shapes.size());
    for (const PatchShape& shape : shapes)
        filler.place(shape);
    return filler.finish();
}

} // namespace esm
