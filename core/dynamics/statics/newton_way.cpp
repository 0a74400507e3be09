#include "core/dynamics/statics/newton_way.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::size_t atOnce = 3; ///< right-hand sides, by a factor

/// A⁻¹·sides, without what stands beside the matrix; 0 at fixed nodes.
std::vector<Vectors> solutions(const PotentialCurvature& curvature, const std::vector<Vectors>& sides) {
    const BlockFactor& factor = curvature.factor;
    const BlockEntries& rows = curvature.rows;
    std::vector<Vectors> result(sides.size(), Vectors(sides.front().size(), Eigen::Vector3d::Zero()));
    std::vector<Eigen::Vector3d> solved(factor.rowCount());
    for (std::size_t first = 0; first < sides.size(); first += atOnce) {
        const std::size_t count = std::min(atOnce, sides.size() - first);
        const auto forEachNumber = [&](const auto& visit) {
            for (std::uint32_t node = 0; node < result.front().size(); ++node)
                for (int axis = 0; rows.rowOf(node) >= 0 && axis < 3; ++axis) {
                    const auto row =
                        static_cast<std::size_t>(rows.rowOf(node)) + static_cast<std::size_t>(axis);
                    const auto place = static_cast<std::size_t>(factor.places()[row]);
                    for (std::size_t k = 0; k < count; ++k)
                        visit(solved[place][static_cast<Eigen::Index>(k)], first + k, node, axis);
                }
        };
        std::fill(solved.begin(), solved.end(), Eigen::Vector3d::Zero());
        forEachNumber([&](double& number, std::size_t side, std::uint32_t node, int axis) {
            number = sides[side][node][axis];
        });
        factor.solveLower(solved);
        factor.solveUpper(solved);
        forEachNumber([&](double number, std::size_t side, std::uint32_t node, int axis) {
            result[side][node][axis] = number;
        });
    }
    return result;
}

} // namespace

// A depth that is sought is one unknown more. It is coupled to all points that are pushed, so that as a row
// of the matrix it would fill the factor. It is eliminated by hand instead (a bordered system), by one more
// right-hand side: with A x + b z = f and bᵀx + s z = g, z is (g − bᵀA⁻¹f) / (s − bᵀA⁻¹b). A fluid takes
// one more as well.
std::optional<NewtonWay> newtonWay(const PotentialCurvature& curvature, const Unbalanced& unbalanced) {
    const auto& [forces, push, pushed] = unbalanced;
    std::vector<Vectors> sides{forces, push.coupling};
    for (const GlobalTerm& term : curvature.terms)
        sides.push_back(term.gradient);
    std::vector<Vectors> solved = solutions(curvature, sides);
    const GlobalCorrection correction(curvature.terms, {solved.begin() + 2, solved.end()});
    Vectors &byForces = solved[0], &byCoupling = solved[1];
    correction.correct(byForces);
    NewtonWay way{0, {}, 0};
    if (pushed) {
        correction.correct(byCoupling);
        const double resistance = push.stiffness - scalarProduct(push.coupling, byCoupling);
        if (!(resistance > 0)) return {};
        way.depth = (*pushed - push.force - scalarProduct(push.coupling, byForces)) / resistance;
        way.slope = (push.force - *pushed) * way.depth;
        addMultiple(byForces, -way.depth, byCoupling);
    }
    way.slope -= scalarProduct(forces, byForces);
    way.nodes = std::move(byForces);
    if (!(way.slope < 0)) return {};
    return way;
}

} // namespace esm
