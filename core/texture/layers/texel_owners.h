#pragma once

#include "core/support/progress.h"
#include "core/texture/atlas/atlas.h"

#include <cstdint>
#include <vector>

namespace esm {

/// Texels next to each other in a row that take the colours of one patch.
struct TexelSpan {
    std::uint32_t triangle;
    std::uint16_t row, first, end;
};

/// Some rows of a page. Every texel lies in at most one span of one strip, so that strips can be filled by
/// any number of threads with the same result.
struct OwnedStrip {
    int page, row;                ///< from the top, counted in strips
    std::vector<TexelSpan> spans; ///< in the mesh's order, those of a triangle from the top left
};

/// Which patch each texel of an atlas takes its colours from: the nearest one within `fillReach`. Found once
/// for all compositions. Immutable.
class TexelOwners {
public:
    /// Precondition: an atlas that is valid for the mesh. @throws Cancelled
    TexelOwners(const TriangleMesh& mesh, const Atlas& atlas, const Progress& progress = {});

    /// Whether another atlas has the same patches.
    bool areOf(const Atlas& atlas) const;
    const std::vector<OwnedStrip>& strips() const { return m_strips; }
    /// Of each triangle: those that lie side by side in the texture as on the surface have one number.
    const std::vector<std::uint32_t>& patches() const { return m_patches; }

private:
    AtlasOptions m_options;
    std::vector<std::array<Eigen::Vector2d, 3>> m_corners;
    std::vector<std::uint16_t> m_page;
    std::vector<OwnedStrip> m_strips;
    std::vector<std::uint32_t> m_patches;
};

} // namespace esm
