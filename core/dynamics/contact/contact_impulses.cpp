#include "core/dynamics/contact/contact_impulses.h"

#include <algorithm>

namespace esm {

namespace {

constexpr int mostSweeps = 200;

std::vector<std::uint32_t> movableNodes(const ContactProblem& problem) {
    std::vector<std::uint32_t> nodes;
    for (const Contact& contact : problem.contacts)
        for (std::size_t i = 0; i < contact.count; ++i)
            if (!problem.immovable[contact.nodes.at(i)]) nodes.push_back(contact.nodes.at(i));
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
    for (std::size_t c = 0; c < shares.size(); ++c) {
        const Contact& contact = problem.contacts[c];
        for (std::size_t i = 0; i < contact.count; ++i) {
            if (problem.immovable[contact.nodes.at(i)]) continue;
            const auto place =
                std::lower_bound(nodes.begin(), nodes.end(), contact.nodes.at(i)) - nodes.begin();
            shares[c].push_back({place, contact.weights.at(i)});
        }
    }
    return shares;
}

/// Change of a contact's normal velocity per impulse on another.
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
                sum * problem.contacts[first].normal.dot(problem.contacts[second].normal);
        }
    return matrix;
}

/// impulses ≥ 0, matrix·impulses ≥ needed, and one of the two with equality for each contact.
void solveComplementarity(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& needed, double tolerance,
                          Eigen::VectorXd& impulses) {
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {
        double largest = 0;
        for (Eigen::Index c = 0; c < impulses.size(); ++c) {
            const double own = matrix(c, c);
            if (!(own > 0)) continue;
            const double missing = needed[c] - matrix.col(c).dot(impulses);
            const double next = std::max(0.0, impulses[c] + missing / own);
            largest = std::max(largest, std::abs(next - impulses[c]) * own);
            impulses[c] = next;
        }
        if (largest <= tolerance) return;
    }
}

} // namespace

void pushContacts(const ContactProblem& problem, NodeImpulses& response, Eigen::VectorXd& impulses,
                  Vectors& half) {
    const std::vector<std::uint32_t> nodes = movableNodes(problem);
    const auto count = static_cast<Eigen::Index>(nodes.size()),
               led = static_cast<Eigen::Index>(problem.led.size());
    std::vector<std::uint32_t> all = nodes;
    all.insert(all.end(), problem.led.begin(), problem.led.end());
    const Eigen::MatrixXd full = response.response(all);

    // Led nodes answer with the impulses that keep them on their way.
    const Eigen::MatrixXd answer = led > 0 ? Eigen::MatrixXd(-full.bottomRightCorner(led, led).llt().solve(
                                                 full.bottomLeftCorner(led, count)))
                                           : Eigen::MatrixXd(0, count);
    const Eigen::MatrixXd nodeResponse =
        full.topLeftCorner(count, count) + full.topRightCorner(count, led) * answer;

    const auto shares = sharesOf(problem, nodes);
    solveComplementarity(contactResponse(problem, shares, nodeResponse), problem.needed, problem.tolerance,
                         impulses);

    Eigen::MatrixX3d nodeImpulses = Eigen::MatrixX3d::Zero(count, 3);
    for (std::size_t c = 0; c < shares.size(); ++c)
        for (const Share& share : shares[c])
            nodeImpulses.row(share.place) += share.weight * impulses[static_cast<Eigen::Index>(c)] *
                                             problem.contacts[c].normal.transpose();
    const Eigen::MatrixX3d ledImpulses = answer * nodeImpulses;
    for (Eigen::Index i = 0; i < count; ++i)
        response.add(all[static_cast<std::size_t>(i)], nodeImpulses.row(i), half);
    for (Eigen::Index i = 0; i < led; ++i)
        response.add(problem.led[static_cast<std::size_t>(i)], ledImpulses.row(i), half);
}

} // namespace esm
