#include "core/texture/atlas/patch_row.h"

#include "core/texture/atlas/reach.h"

#include <algorithm>
#include <limits>

namespace esm {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

} // namespace

PatchCorners cornersInRow(const PatchShape& shape, double texelsPerMetre, double rowHeight,
                          const PatchStance& stance) {
    const double base = texelsPerMetre * shape.base, height = texelsPerMetre * shape.height;
    const double foot = texelsPerMetre * shape.foot;
    // To turn a patch upside down mirrors its base too.
    const bool fromRight = stance.pointsUp == stance.isMirrored;
    const double border = stance.pointsUp ? rowHeight : 0;
    const double tip = stance.pointsUp ? rowHeight - height : height;
    if (fromRight) return {{{base, border}, {0, border}, {base - foot, tip}}};
    return {{{0, border}, {base, border}, {foot, tip}}};
}

double rightEnd(const PatchCorners& corners) {
    return std::max({corners[0].x(), corners[1].x(), corners[2].x()});
}

void shift(PatchCorners& corners, double x, double y) {
    for (Eigen::Vector2d& corner : corners)
        corner += Eigen::Vector2d(x, y);
}

/// Two triangles that do not overlap are nearest at a corner of one and a side of the other. So the touching
/// positions are found from the 18 pairs of those alone, each solved exactly: the corner pushes the side, or
/// the side the corner, until they are a gap apart. The largest of these shifts clears them all. (It is the
/// no-fit polygon of the two, asked along one line, without building it.)
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

double PatchRow::shiftFor(const PatchCorners& moving, double start, double gap) const {
    double result = start;
    for (std::size_t i = m_patches.size(); i-- > 0 && m_reach[i] + gap > result;)
        result = std::max(result, clearingShift(m_patches[i], moving, gap));
    return result;
}

void PatchRow::add(const PatchCorners& corners) {
    m_reach.push_back(std::max(rightEnd(corners), m_reach.empty() ? -never : m_reach.back()));
    m_patches.push_back(corners);
}

void PatchRow::clear() {
    m_patches.clear();
    m_reach.clear();
}

} // namespace esm
