#include "core/texture/layers/patch_scan.h"

#include "core/texture/atlas/reach.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int rowsPerBand = 32;

/// A centre farther out than this is no neighbour in bilinear filtering and takes the patch's border colour.
constexpr double extension = 1.5;

/// Below this share of the sides' squares a patch's area is rounding error: no texel's centre lies inside.
constexpr double singular = 1e-10;

double nearestFraction(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double square = along.squaredNorm();
    return square > 0 ? std::clamp((point - a).dot(along) / square, 0.0, 1.0) : 0;
}

} // namespace

double fillReach(const AtlasOptions& options) {
    return std::clamp(static_cast<double>(options.gap), 2.0, 16.0);
}

std::vector<PageBand> pageBands(const Atlas& atlas) {
    const int size = atlas.options.size, perPage = (size + rowsPerBand - 1) / rowsPerBand;
    const double reach = fillReach(atlas.options);
    std::vector<PageBand> bands;
    for (int page = 0; page < atlas.options.pages; ++page)
        for (int row = 0; row < size; row += rowsPerBand)
            bands.push_back({page, row, std::min(row + rowsPerBand, size), {}});
    for (std::size_t i = 0; i < atlas.corners.size(); ++i) {
        const auto& c = atlas.corners[i];
        const double top = std::min({c[0].y(), c[1].y(), c[2].y()}) - reach;
        const double bottom = std::max({c[0].y(), c[1].y(), c[2].y()}) + reach;
        const int first = std::max(0, static_cast<int>(top) / rowsPerBand);
        const int last = std::min(perPage - 1, static_cast<int>(bottom) / rowsPerBand);
        const std::size_t page = static_cast<std::size_t>(atlas.page[i]) * static_cast<std::size_t>(perPage);
        for (int band = first; band <= last; ++band)
            bands[page + static_cast<std::size_t>(band)].triangles.push_back(static_cast<std::uint32_t>(i));
    }
    return bands;
}

PatchScan::PatchScan(const std::array<Eigen::Vector2d, 3>& corners)
    : m_corners(corners), m_top(std::min({corners[0].y(), corners[1].y(), corners[2].y()})),
      m_bottom(std::max({corners[0].y(), corners[1].y(), corners[2].y()})) {
    Eigen::Matrix2d sides;
    sides << corners[1] - corners[0], corners[2] - corners[0];
    m_isPoint = !(std::abs(sides.determinant()) > singular * sides.squaredNorm());
    m_inverse = m_isPoint ? Eigen::Matrix2d::Zero() : Eigen::Matrix2d(sides.inverse());
}

std::pair<double, double> PatchScan::span(double y, double reach) const {
    std::pair<double, double> ends{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &a = m_corners[i], &b = m_corners[(i + 1) % 3];
        ends.first = std::min(ends.first, leftReach(a, b, y, reach));
        ends.second = std::max(ends.second, rightReach(a, b, y, reach));
    }
    return ends;
}

Eigen::Vector3d PatchScan::weights(const Eigen::Vector2d& point) const {
    if (m_isPoint) return Eigen::Vector3d::Constant(1.0 / 3);
    const Eigen::Vector2d others = m_inverse * (point - m_corners[0]);
    return {1 - others.sum(), others.x(), others.y()};
}

PatchTexel PatchScan::texel(int x, int y) const {
    const Eigen::Vector2d centre(x + 0.5, y + 0.5);
    const Eigen::Vector3d inside = weights(centre);
    if (!m_isPoint && inside.minCoeff() >= 0) return {x, y, 0, inside, inside};
    PatchTexel texel{x, y, std::numeric_limits<double>::infinity(), inside, inside};
    Eigen::Vector2d nearest = centre;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        const double fraction = nearestFraction(centre, m_corners[i], m_corners[next]);
        const Eigen::Vector2d point = m_corners[i] + fraction * (m_corners[next] - m_corners[i]);
        const double distance = (point - centre).norm();
        if (distance >= texel.distance) continue;
        texel.distance = distance;
        nearest = point;
        if (m_isPoint) continue;
        texel.nearest.setZero();
        texel.nearest[static_cast<Eigen::Index>(i)] = 1 - fraction;
        texel.nearest[static_cast<Eigen::Index>(next)] = fraction;
    }
    if (texel.distance > extension)
        texel.extended = weights(nearest + extension / texel.distance * (centre - nearest));
    return texel;
}

BandOwners::BandOwners(const Atlas& atlas, const PageBand& band, double reach)
    : m_firstRow(band.firstRow), m_width(atlas.options.size) {
    const std::size_t count =
        static_cast<std::size_t>(band.endRow - band.firstRow) * static_cast<std::size_t>(m_width);
    std::vector<double> distance(count, std::numeric_limits<double>::infinity());
    m_owner.assign(count, nobody);
    for (const std::uint32_t triangle : band.triangles) {
        PatchScan(atlas.corners[triangle]).forEachTexel(band, m_width, reach, [&](const PatchTexel& texel) {
            const std::size_t i = index(texel.x, texel.y);
            if (texel.distance >= distance[i]) return;
            distance[i] = texel.distance;
            m_owner[i] = triangle;
        });
    }
}

} // namespace esm
