#include "core/dynamics/statics/newton_way.h"

namespace esm {

namespace {

/// Calls `visit` with a node, an axis, the matrix' row of both and the factor's row.
template<class Visit>
void forEachRow(const BlockFactor& factor, const BlockEntries& rows, std::size_t nodes, const Visit& visit) {
    for (std::uint32_t node = 0; node < nodes; ++node)
        for (int axis = 0; rows.rowOf(node) >= 0 && axis < 3; ++axis) {
            const int row = rows.rowOf(node) + axis;
            visit(node, axis, row, static_cast<std::size_t>(factor.places()[static_cast<std::size_t>(row)]));
        }
}

} // namespace

// A depth that is sought is one unknown more. It is coupled to all points that are pushed, so that as a row
// of the matrix it would fill the factor. It is eliminated by hand instead (a bordered system), by one more
// right-hand side: with A x + b z = f and bᵀx + s z = g, z is (g − bᵀA⁻¹f) / (s − bᵀA⁻¹b).
std::optional<NewtonWay> newtonWay(const BlockFactor& factor, const BlockEntries& rows,
                                   const Unbalanced& unbalanced) {
    const Vectors& forces = unbalanced.forces;
    const PushAlong& push = unbalanced.push;
    const std::optional<double>& pushed = unbalanced.pushed;
    std::vector<Eigen::Vector3d> solved(factor.rowCount());
    forEachRow(factor, rows, forces.size(), [&](std::uint32_t node, int axis, int row, std::size_t place) {
        solved[place] = {forces[node][axis], push.coupling[row], 0};
    });
    const std::vector<Eigen::Vector3d> sides = solved;
    factor.solveLower(solved);
    factor.solveUpper(solved);
    NewtonWay way{0, Vectors(forces.size(), Eigen::Vector3d::Zero()), 0};
    if (pushed) {
        double taken = 0, resistance = push.stiffness;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            taken += sides[i].y() * solved[i].x();
            resistance -= sides[i].y() * solved[i].y();
        }
        if (!(resistance > 0)) return {};
        way.depth = (*pushed - push.force - taken) / resistance;
        way.slope = (push.force - *pushed) * way.depth;
    }
    forEachRow(factor, rows, forces.size(), [&](std::uint32_t node, int axis, int, std::size_t place) {
        way.nodes[node][axis] = solved[place].x() - way.depth * solved[place].y();
    });
    for (std::size_t i = 0; i < forces.size(); ++i)
        way.slope -= forces[i].dot(way.nodes[i]);
    if (!(way.slope < 0)) return {};
    return way;
}

} // namespace esm
