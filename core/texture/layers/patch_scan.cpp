#include "core/texture/layers/patch_scan.h"

#include "core/texture/atlas/reach.h"

#include <algorithm>

namespace esm {

namespace {

/// A centre farther out than this is no neighbour in bilinear filtering and takes the patch's border colour.
constexpr double extension = 1.5;

/// Below this share of the sides' squares a patch's area is rounding error: no texel's centre lies inside.
constexpr double singular = 1e-10;

} // namespace

double fillReach(const AtlasOptions& options) {
    return std::clamp(static_cast<double>(options.gap), 2.0, 16.0);
}

/// Strips of whole rows, each with all patches that reach into it. A patch that lies in two strips is scanned
/// twice; for that, no two threads ever write to one texel, and the result does not depend on their number.
std::vector<PageStrip> pageStrips(const Atlas& atlas) {
    const int size = atlas.options.size, perPage = (size + rowsPerStrip - 1) / rowsPerStrip;
    const double reach = fillReach(atlas.options);
    std::vector<PageStrip> strips;
    for (int page = 0; page < atlas.options.pages; ++page)
        for (int row = 0; row < size; row += rowsPerStrip)
            strips.push_back({page, row, std::min(row + rowsPerStrip, size), {}});
    for (std::size_t i = 0; i < atlas.corners.size(); ++i) {
        const auto& c = atlas.corners[i];
        const double top = std::min({c[0].y(), c[1].y(), c[2].y()}) - reach;
        const double bottom = std::max({c[0].y(), c[1].y(), c[2].y()}) + reach;
        const int first = std::max(0, static_cast<int>(top) / rowsPerStrip);
        const int last = std::min(perPage - 1, static_cast<int>(bottom) / rowsPerStrip);
        const std::size_t page = static_cast<std::size_t>(atlas.page[i]) * static_cast<std::size_t>(perPage);
        for (int strip = first; strip <= last; ++strip)
            strips[page + static_cast<std::size_t>(strip)].triangles.push_back(static_cast<std::uint32_t>(i));
    }
    return strips;
}

PatchScan::PatchScan(const std::array<Eigen::Vector2d, 3>& corners)
    : m_top(std::min({corners[0].y(), corners[1].y(), corners[2].y()})),
      m_bottom(std::max({corners[0].y(), corners[1].y(), corners[2].y()})) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d along = corners[(i + 1) % 3] - corners[i];
        const double perSquare = 1 / along.squaredNorm();
        m_sides[i] = {corners[i], along, std::isfinite(perSquare) ? perSquare : 0};
    }
    Eigen::Matrix2d sides;
    sides << corners[1] - corners[0], corners[2] - corners[0];
    m_isPoint = !(std::abs(sides.determinant()) > singular * sides.squaredNorm());
    m_inverse = m_isPoint ? Eigen::Matrix2d::Zero() : Eigen::Matrix2d(sides.inverse());
}

std::pair<double, double> PatchScan::span(double y, double reach) const {
    std::pair<double, double> ends{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &a = m_sides[i].start, &b = m_sides[(i + 1) % 3].start;
        ends.first = std::min(ends.first, leftReach(a, b, y, reach));
        ends.second = std::max(ends.second, rightReach(a, b, y, reach));
    }
    return ends;
}

/// The nearest point of the nearest side says where on the surface the texel is lit. Its colour goes on a
/// little beyond the side in the triangle's plane, so that bilinear filtering across the side reads what the
/// photo shows there; farther out, where the plane may have left the organ and the photo, the colour of the
/// border is repeated.
PatchTexel PatchScan::texelAround(int x, int y, const Eigen::Vector3d& inside) const {
    const Eigen::Vector2d centre(x + 0.5, y + 0.5);
    std::size_t side = 0;
    for (const std::size_t other : {1U, 2U})
        if (m_sides[other].squaredDistance(centre) < m_sides[side].squaredDistance(centre)) side = other;
    const Eigen::Vector2d nearest = m_sides[side].nearest(centre);
    PatchTexel texel{x, y, (nearest - centre).norm(), inside, inside};
    if (!m_isPoint) {
        const double fraction = m_sides[side].fraction(centre);
        texel.nearest.setZero();
        texel.nearest[static_cast<Eigen::Index>(side)] = 1 - fraction;
        texel.nearest[static_cast<Eigen::Index>((side + 1) % 3)] = fraction;
    }
    if (texel.distance > extension)
        texel.extended = weights(nearest + extension / texel.distance * (centre - nearest));
    return texel;
}

/// Texels between two patches go to the nearer one, so that each has half of the gap. Patches come in the
/// mesh's order and only a smaller distance takes a texel over: of equals the first keeps it, whatever thread
/// scans the strip. Squared distances do for comparing and need no root.
StripOwners::StripOwners(const Atlas& atlas, const PageStrip& strip, double reach)
    : m_firstRow(strip.firstRow), m_width(atlas.options.size) {
    const std::size_t count =
        static_cast<std::size_t>(strip.endRow - strip.firstRow) * static_cast<std::size_t>(m_width);
    std::vector<double> distance(count, std::numeric_limits<double>::infinity());
    m_owner.assign(count, nobody);
    for (const std::uint32_t triangle : strip.triangles) {
        const PatchScan patch(atlas.corners[triangle]);
        patch.forEachPlace(strip, m_width, reach, [&](int x, int y) {
            const std::size_t i = index(x, y);
            if (distance[i] == 0) return;
            const double own = patch.squaredDistance(x, y);
            if (own >= distance[i]) return;
            distance[i] = own;
            m_owner[i] = triangle;
        });
    }
}

} // namespace esm
