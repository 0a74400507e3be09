#include "core/texture/atlas/row_layout.h"

#include <algorithm>

namespace esm {

namespace {

/// The source's rows [R 4.3.2.2]: in the order of their heights, third corner up and down in turn, so that
/// the slants of two neighbours lean the same way. One pass, no choice: what is left at a row's end stays
/// empty.
class RowFiller {
public:
    RowFiller(const PageRoom& page, double scale, std::size_t count)
        : m_scale(scale), m_gap(page.gap), m_stack(page) {
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
        shift(corners, 0, m_stack.top());
        m_layout.corners.push_back(corners);
        m_layout.page.push_back(m_stack.page());
    }

    PatchLayout finish() {
        m_layout.pages = m_stack.pages();
        m_layout.height = m_stack.totalHeight();
        return std::move(m_layout);
    }

private:
    bool fits(const PatchShape& shape, PatchCorners& corners) const {
        corners = cornersInRow(shape, m_scale, m_rowHeight, {m_pointsUp, false});
        shift(corners, m_row.shiftFor(corners, m_stack.left(), m_gap), 0);
        return rightEnd(corners) <= m_stack.right();
    }

    void startRow(double height) {
        m_stack.startRow(height);
        m_rowHeight = height;
        m_pointsUp = true;
        m_row.clear();
    }

    double m_scale, m_gap;
    RowStack m_stack;
    double m_rowHeight = 0; ///< pixels
    bool m_pointsUp = true;
    PatchRow m_row;
    PatchLayout m_layout;
};

} // namespace

void RowStack::startRow(double height) {
    if (!m_isEmpty) m_y += m_height + m_gap;
    if (m_y + height > m_end) {
        ++m_page;
        m_y = m_border;
    }
    m_height = height;
    m_isEmpty = false;
}

/// Of too small a scale thousands of pages may come; the layout is refused by their number, and the number of
/// a page must not wrap around before.
std::uint16_t RowStack::page() const {
    return static_cast<std::uint16_t>(std::min(m_page, 0xffff));
}

bool fitOnAPage(const std::vector<PatchShape>& shapes, double texelsPerMetre, const PageRoom& page) {
    const double room = page.size - page.gap;
    return std::all_of(shapes.begin(), shapes.end(), [&](const PatchShape& shape) {
        return std::max(shape.base, shape.height) * texelsPerMetre <= room;
    });
}

PatchLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const PageRoom& page,
                       const Progress& progress) {
    if (!fitOnAPage(shapes, texelsPerMetre, page)) return {};
    RowFiller filler(page, texelsPerMetre, shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        reportStep(progress, i, shapes.size());
        filler.place(shapes[i]);
    }
    reportProgress(progress, 1);
    return filler.finish();
}

} // namespace esm
