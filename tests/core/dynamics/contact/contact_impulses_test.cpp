#include "core/dynamics/contact/contact_impulses.h"
#include "core/dynamics/contact/contact_point.h"
#include "tests/support/tissue_models.h"

#include <gtest/gtest.h>

using namespace esm;
using Eigen::Vector3d;
using tissue::Vectors;

namespace {

/// On so many nodes in a row, with shares that grow, as a point has them that a lattice or a surface carries.
Contact contactOn(std::uint32_t first, std::uint32_t count, const Vector3d& normal) {
    Contact contact{{}, 0, AxisPart::First, 0.01, 0, {{0, 0, 0}, normal.normalized()}, {0.1, -0.2, 0.3}};
    for (std::uint32_t i = 0; i < count; ++i)
        contact.shares.push_back({first + i, (2.0 * i + 1) / (count * count)});
    return contact;
}

/// Nodes at rest that contacts push.
struct Pushed {
    SpringSystem system = makeSpringSystem(tissue::fromMesh(tissue::gridMesh(5, 0.1), {10, 0.5, 0.001}));
    std::vector<char> immovable = std::vector<char>(25, 0);
    Eigen::VectorXd impulses; ///< N·s
    Vectors velocities;       ///< m/s

    void push(const std::vector<Contact>& contacts, const Eigen::VectorXd& needed) {
        MatrixFactoriser factoriser;
        const StepMatrix matrix(system, {1, 0.01, 0}, immovable, factoriser);
        NodeImpulses response(matrix);
        velocities.assign(25, Vector3d::Zero());
        impulses = Eigen::VectorXd::Zero(needed.size());
        Vectors half;
        matrix.solveLower(velocities, velocities, half);
        pushContacts({contacts, needed, {}, immovable, 1e-15, {}}, response, impulses, half);
        matrix.solveUpper(half, velocities);
    }

    /// m/s, of the contact's point along its normal.
    double speed(const Contact& contact) const {
        Contact withoutArm = contact;
        withoutArm.arm.setZero();
        return contact.plane.normal.dot(pointOf(withoutArm, velocities));
    }

    Vector3d momentum() const {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t node = 0; node < velocities.size(); ++node)
            sum += system.mass[node] * velocities[node];
        return sum;
    }
};

// Springs and their viscosity only hand momentum on from node to node: what the nodes get is what the
// instrument gave.
TEST(ContactImpulses, GiveAPointOfAnyNumberOfNodesItsSpeedAndTheNodesTheImpulse) {
    for (const std::uint32_t count : {1U, 2U, 3U, 4U, 9U}) {
        SCOPED_TRACE(count);
        const Contact contact = contactOn(7, count, {1, -2, 0.5});
        Pushed pushed;
        pushed.push({contact}, Eigen::VectorXd::Constant(1, 0.3));
        EXPECT_GT(pushed.impulses[0], 0);
        EXPECT_NEAR(pushed.speed(contact), 0.3, 1e-12);
        const Vector3d given = pushed.impulses[0] * contact.plane.normal;
        EXPECT_LT((pushed.momentum() - given).norm(), 1e-10 * given.norm());
    }
}

TEST(ContactImpulses, BetweenPointsOfDifferentNumbersOfNodesOnlyPush) {
    const std::vector<Contact> contacts{contactOn(2, 9, {0, 0, 1}), contactOn(8, 4, {0, 1, 1}),
                                        contactOn(5, 2, {0, 0, 1})};
    Pushed pushed;
    pushed.push(contacts, Eigen::Vector3d(0.3, 0.5, -0.2));
    Vector3d given = Vector3d::Zero();
    const double needed[]{0.3, 0.5, -0.2};
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double impulse = pushed.impulses[static_cast<Eigen::Index>(i)];
        given += impulse * contacts[i].plane.normal;
        EXPECT_GE(impulse, 0);
        EXPECT_GT(pushed.speed(contacts[i]), needed[i] - 1e-9);
        if (impulse > 0) {
            EXPECT_NEAR(pushed.speed(contacts[i]), needed[i], 1e-9);
        }
    }
    EXPECT_EQ(pushed.impulses[2], 0) << "the others take it along faster than it needs";
    EXPECT_LT((pushed.momentum() - given).norm(), 1e-10 * given.norm());
}

TEST(ContactImpulses, LieOnTheNodesThatCanGiveWay) {
    const Contact contact = contactOn(0, 9, {0, 0, 1});
    Pushed pushed;
    pushed.immovable[3] = pushed.immovable[8] = 1;
    pushed.push({contact}, Eigen::VectorXd::Constant(1, 0.3));
    EXPECT_NEAR(pushed.speed(contact), 0.3, 1e-12);
    EXPECT_EQ(pushed.velocities[3], Vector3d(0, 0, 0));
    EXPECT_EQ(pushed.velocities[8], Vector3d(0, 0, 0));
}

} // namespace
