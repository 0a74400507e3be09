#pragma once

#include "core/texture/atlas/atlas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace esm {

constexpr int rowsPerStrip = 32; ///< but in the last one of a page

/// Some rows of a page and the patches whose surroundings reach into them. Every texel lies in exactly one
/// strip, so that strips can be filled by any number of threads with the same result.
struct PageStrip {
    int page, firstRow, endRow;
    std::vector<std::uint32_t> triangles; ///< in the mesh's order
};

/// Texels around a patch that take its colours: enough for bilinear filtering and for what the gap leaves
/// free.
double fillReach(const AtlasOptions& options);

/// All pages in strips, from top to bottom.
std::vector<PageStrip> pageStrips(const Atlas& atlas);

/// A texel seen from a patch.
struct PatchTexel {
    int x, y;
    double distance;          ///< of its centre from the patch, texels; 0 inside
    Eigen::Vector3d nearest;  ///< the patch's point nearest to its centre, weights of the triangle's corners
    Eigen::Vector3d extended; ///< its centre in the triangle's plane, the same where it lies inside
};

/// A patch with its inverse map from texels to the triangle's corners. One without area has no inverse: it
/// is scanned like a point, and every texel near it sees the triangle's middle. Precondition: the corners lie
/// on the page.
class PatchScan {
public:
    explicit PatchScan(const std::array<Eigen::Vector2d, 3>& corners);

    /// Calls `visit(PatchTexel)` for every texel of the strip within `reach` of the patch.
    template<class Visit>
    void forEachTexel(const PageStrip& strip, int pageSize, double reach, Visit visit) const {
        forEachPlace(strip, pageSize, reach, [&](int x, int y) { visit(texel(x, y)); });
    }

    /// Calls `visit(x, y)` for the same texels.
    template<class Visit>
    void forEachPlace(const PageStrip& strip, int pageSize, double reach, Visit visit) const {
        const int first = std::max(strip.firstRow, static_cast<int>(std::floor(m_top - reach)));
        const int end = std::min(strip.endRow, static_cast<int>(std::ceil(m_bottom + reach)) + 1);
        for (int y = first; y < end; ++y) {
            const auto [left, right] = span(y + 0.5, reach);
            if (left > right) continue;
            const int last = std::min(pageSize - 1, static_cast<int>(std::floor(right - 0.5)));
            for (int x = std::max(0, static_cast<int>(std::ceil(left - 0.5))); x <= last; ++x)
                visit(x, y);
        }
    }

    PatchTexel texel(int x, int y) const {
        const Eigen::Vector3d inside = weights({x + 0.5, y + 0.5});
        if (!m_isPoint && inside.minCoeff() >= 0) return {x, y, 0, inside, inside};
        return texelAround(x, y, inside);
    }

    /// Of a texel's centre from the patch, texels²; 0 inside.
    double squaredDistance(int x, int y) const {
        const Eigen::Vector2d centre(x + 0.5, y + 0.5);
        if (!m_isPoint && weights(centre).minCoeff() >= 0) return 0;
        return std::min({m_sides[0].squaredDistance(centre), m_sides[1].squaredDistance(centre),
                         m_sides[2].squaredDistance(centre)});
    }

private:
    struct Side {
        Eigen::Vector2d start, along;
        double perSquaredLength; ///< 0 of one without length

        Eigen::Vector2d nearest(const Eigen::Vector2d& point) const {
            return start + fraction(point) * along;
        }
        double fraction(const Eigen::Vector2d& point) const {
            return std::clamp((point - start).dot(along) * perSquaredLength, 0.0, 1.0);
        }
        double squaredDistance(const Eigen::Vector2d& point) const {
            return (nearest(point) - point).squaredNorm();
        }
    };

    /// The points of a line within `reach` of the patch.
    std::pair<double, double> span(double y, double reach) const;
    /// Of a texel whose centre lies outside; `inside` are the weights there.
    PatchTexel texelAround(int x, int y, const Eigen::Vector3d& inside) const;
    Eigen::Vector3d weights(const Eigen::Vector2d& point) const {
        if (m_isPoint) return Eigen::Vector3d::Constant(1.0 / 3);
        const Eigen::Vector2d others = m_inverse * (point - m_sides[0].start);
        return {1 - others.x() - others.y(), others.x(), others.y()};
    }

    std::array<Side, 3> m_sides;
    Eigen::Matrix2d
        m_inverse; ///< from the first corner's offset to the weights of the other two; 0 for a point
    bool m_isPoint;
    double m_top, m_bottom;
};

/// Owners of a strip's texels: the nearest patch, the mesh's first among equals.
class StripOwners {
public:
    static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

    StripOwners(const Atlas& atlas, const PageStrip& strip, double reach);
    std::uint32_t at(int x, int y) const { return m_owner[index(x, y)]; }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - m_firstRow) * static_cast<std::size_t>(m_width) +
               static_cast<std::size_t>(x);
    }

    int m_firstRow, m_width;
    std::vector<std::uint32_t> m_owner;
};

} // namespace esm
