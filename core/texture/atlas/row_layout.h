#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/patch_layout.h"

namespace esm {

/// Where rows come to lie, one below the other and page after page.
class RowStack {
public:
    explicit RowStack(const PageRoom& page)
        : m_gap(page.gap), m_border(page.gap / 2), m_end(page.size - page.gap / 2), m_y(m_border) {}

    /// Of so many pixels; on the next page where this one has no room left.
    void startRow(double height);

    double left() const { return m_border; } ///< pixels, where rows begin
    double right() const { return m_end; }
    double top() const { return m_y; } ///< of the row
    std::uint16_t page() const;        ///< of the row
    int pages() const { return m_page + 1; }
    /// Pixels that all rows take, one page after the other.
    double totalHeight() const { return m_page * (m_end - m_border) + m_y + m_height - m_border; }

private:
    double m_gap, m_border, m_end;
    double m_y, m_height = 0;
    int m_page = 0;
    bool m_isEmpty = true;
};

/// Whether each of the shapes has room on a page, though perhaps no two of them.
bool fitOnAPage(const std::vector<PatchShape>& shapes, double texelsPerMetre, const PageRoom& page);

/// Rows of triangles with the third corner alternately up and down [R 4.3.2.2]. The shapes come tallest
/// first, so that a row's height is known when it starts. Every patch keeps the gap to all others, not just
/// to the one before.
PatchLayout layoutRows(const std::vector<PatchShape>& shapes, double texelsPerMetre, const PageRoom& page,
                       const Progress& progress = {});

} // namespace esm
