#include "core/dynamics/contact/contact_impulses.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int mostSweeps = 200;

std::vector<std::uint32_t> movableNodes(const ContactProblem& problem) {
    std::vector<std::uint32_t> nodes;
    for (const Contact& contact : problem.contacts)
        for (const NodeShare& share : contact.shares)
            if (!problem.immovable[share.node]) nodes.push_back(share.node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// A contact's movable nodes, by their places in the list of all.
struct Share {
    Eigen::Index place;
    double weight;
};
std::vector<std::vector<Share>> sharesOf(const ContactProblem& problem,
                                         const std::vector<std::uint32_t>& nodes) {
    std::vector<std::vector<Share>> shares(problem.contacts.size());
    for (std::size_t c = 0; c < shares.size(); ++c)
        for (const auto& [node, weight] : problem.contacts[c].shares) {
            if (problem.immovable[node]) continue;
            const auto place = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
            shares[c].push_back({place, weight});
        }
    return shares;
}

/// Change of a contact's normal velocity per impulse on another: N·A⁻¹·Nᵀ, where N makes normal velocities of
/// those of the nodes. The step's matrix is the same for x, y and z, so that each pair of contacts takes a
/// number of A⁻¹ times the cosine between their normals.
Eigen::MatrixXd contactResponse(const ContactProblem& problem, const std::vector<std::vector<Share>>& shares,
                                const Eigen::MatrixXd& nodeResponse) {
    const auto size = static_cast<Eigen::Index>(shares.size());
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index a = 0; a < size; ++a)
        for (Eigen::Index b = 0; b <= a; ++b) {
            const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
            double sum = 0;
            for (const Share& one : shares[first])
                for (const Share& other : shares[second])
                    sum += one.weight * other.weight * nodeResponse(one.place, other.place);
            matrix(a, b) = matrix(b, a) =
                sum * problem.contacts[first].plane.normal.dot(problem.contacts[second].plane.normal);
        }
    return matrix;
}

/// The contacts' normal velocities by which each fluid's response moves them: one column for each.
Eigen::MatrixXd fluidMotion(const ContactProblem& problem) {
    const std::vector<Vectors>& responses = problem.fluids.correction.responses();
    Eigen::MatrixXd motion(static_cast<Eigen::Index>(problem.contacts.size()),
                           static_cast<Eigen::Index>(responses.size()));
    for (Eigen::Index c = 0; c < motion.rows(); ++c)
        for (Eigen::Index i = 0; i < motion.cols(); ++i) {
            const Contact& contact = problem.contacts[static_cast<std::size_t>(c)];
            motion(c, i) = 0;
            for (const auto& [node, weight] : contact.shares)
                if (!problem.immovable[node])
                    motion(c, i) +=
                        weight * contact.plane.normal.dot(responses[static_cast<std::size_t>(i)][node]);
        }
    return motion;
}

/// How movable and led nodes answer to impulses.
struct NodeAnswers {
    std::vector<std::uint32_t> nodes; ///< movable ones, then led ones
    Eigen::Index movable;             ///< how many of them
    Eigen::MatrixXd led;              ///< impulses that keep led nodes on their way, per impulse
    Eigen::MatrixXd velocities;       ///< of movable nodes per impulse on them, 1/kg
};

/// Led nodes must not give way, but the factorised matrix does not know them. Each impulse therefore comes
/// with others, on the led nodes, that give these back the velocity it took: a small dense system in place of
/// a new factorisation.
NodeAnswers answersOf(const ContactProblem& problem, NodeImpulses& response) {
    NodeAnswers answers;
    answers.nodes = movableNodes(problem);
    const auto count = answers.movable = static_cast<Eigen::Index>(answers.nodes.size());
    const auto led = static_cast<Eigen::Index>(problem.led.size());
    answers.nodes.insert(answers.nodes.end(), problem.led.begin(), problem.led.end());
    const Eigen::MatrixXd full = response.response(answers.nodes);
    answers.led = led > 0 ? Eigen::MatrixXd(-full.bottomRightCorner(led, led).llt().solve(
                                full.bottomLeftCorner(led, count)))
                          : Eigen::MatrixXd(0, count);
    answers.velocities = full.topLeftCorner(count, count) + full.topRightCorner(count, led) * answers.led;
    return answers;
}

/// impulses ≥ 0, matrix·impulses ≥ needed, and one of the two with equality for each contact.
///
/// Projected Gauss-Seidel (Cryer 1971): each contact in turn takes the impulse that it needs beside those of
/// the others, but never one that pulls. The matrix is symmetric and has no negative eigenvalue, for which
/// the method settles; it begins with the impulses of the round before and may stop at any sweep. Pivoting
/// methods are exact, but who is pushed and who is not would have to be found one after the other. What 200
/// sweeps leave is moved out afterwards (projectOut()).
void solveComplementarity(const Eigen::MatrixXd& matrix, const ContactProblem& problem,
                          Eigen::VectorXd& impulses) {
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {
        double largest = 0;
        for (Eigen::Index c = 0; c < impulses.size(); ++c) {
            const double own = matrix(c, c);
            if (!(own > 0)) continue;
            const double missing = problem.needed[c] - matrix.col(c).dot(impulses);
            const double next = std::max(0.0, impulses[c] + missing / own);
            largest = std::max(largest, std::abs(next - impulses[c]) * own);
            impulses[c] = next;
        }
        if (largest <= problem.tolerance) return;
    }
}

/// In the half-solved step, where an impulse on a node is one sparse column.
void lay(const ContactProblem& problem, const NodeAnswers& answers,
         const std::vector<std::vector<Share>>& shares, const Eigen::VectorXd& impulses,
         const NodeImpulses& response, Vectors& half) {
    Eigen::MatrixX3d onNodes = Eigen::MatrixX3d::Zero(answers.movable, 3);
    for (std::size_t c = 0; c < shares.size(); ++c)
        for (const Share& share : shares[c])
            onNodes.row(share.place) += share.weight * impulses[static_cast<Eigen::Index>(c)] *
                                        problem.contacts[c].plane.normal.transpose();
    const Eigen::MatrixX3d onLed = answers.led * onNodes;
    for (Eigen::Index i = 0; i < answers.movable; ++i)
        response.add(answers.nodes[static_cast<std::size_t>(i)], onNodes.row(i), half);
    for (std::size_t i = 0; i < problem.led.size(); ++i)
        response.add(problem.led[i], onLed.row(static_cast<Eigen::Index>(i)), half);
    if (!problem.fluids.isEmpty())
        problem.fluids.takeOff(
            problem.fluids.correction.excessOf(fluidMotion(problem).transpose() * impulses), half);
}

} // namespace

void pushContacts(const ContactProblem& problem, NodeImpulses& response, Eigen::VectorXd& impulses,
                  Vectors& half) {
    const NodeAnswers answers = answersOf(problem, response);
    const auto shares = sharesOf(problem, {answers.nodes.begin(), answers.nodes.begin() + answers.movable});
    Eigen::MatrixXd matrix = contactResponse(problem, shares, answers.velocities);
    if (!problem.fluids.isEmpty()) {
        const Eigen::MatrixXd motion = fluidMotion(problem);
        matrix -= motion * problem.fluids.correction.excessOf(motion.transpose());
    }
    solveComplementarity(matrix, problem, impulses);
    lay(problem, answers, shares, impulses, response, half);
}

void layImpulses(const ContactProblem& problem, NodeImpulses& response, const Eigen::VectorXd& impulses,
                 Vectors& half) {
    const NodeAnswers answers = answersOf(problem, response);
    lay(problem, answers, sharesOf(problem, {answers.nodes.begin(), answers.nodes.begin() + answers.movable}),
        impulses, response, half);
}

} // namespace esm
