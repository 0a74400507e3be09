#include "core/texture/row_layout.h"

#include <algorithm>

namespace esm {

namespace {

class RowFiller {
public:
    RowFiller(const RowPage& page, double scale, std::size_t count)
        : m_scale(scale), m_gap(page.gap), m_border(page.gap / 2), m_end(page.size - page.gap / 2) {
        m_layout.corners.reserve(count);
        m_layout.page.reserve(count);
    }

    void place(const PatchShape& shape) {
        PatchCorners corners;
        if (m_row.isEmpty() || !fits(shape, corners)) {
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
        corners = cornersInRow(shape, m_scale, m_rowHeight, {m_pointsUp, false});
        shift(corners, m_row.shiftFor(corners, m_border, m_gap), 0);
        return rightEnd(corners) <= m_end;
    }

    void startRow(double height) {
        if (!m_row.isEmpty()) m_y += m_rowHeight + m_gap;
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
    PatchRow m_row;
    RowLayout m_layout;
};

} // namespace

bool fitOnAPage(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page) {
    const double room = page.size - page.gap;
    return std::all_of(shapes.begin(), shapes.end(), [&](const PatchShape& shape) {
        return std::max(shape.base, shape.height) * texelsPerMetre <= room;
    });
}

RowLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const RowPage& page) {
    if (!fitOnAPage(shapes, texelsPerMetre, page)) return {};
    RowFiller filler(page, texelsPerMetre, shapes.size());
    for (const PatchShape& shape : shapes)
        filler.place(shape);
    return filler.finish();
}

} // namespace esm
