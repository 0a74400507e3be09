#pragma once

#include "core/dynamics/forces.h"
#include "core/exchange/simulators/exporters.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <random>

namespace esm {

/// Writes organs for MuJoCo into a folder that goes away.
class MujocoExport : public testing::Test {
protected:
    static const Exporter& exporter() { return exporterFor("organ.mjcf"); }

    static HandoverMeans meansFor(Damping damping, std::optional<double> timeStep = std::nullopt) {
        HandoverMeans means;
        means.engine.damping = damping;
        means.engine.timeStep = timeStep;
        return means;
    }

    std::filesystem::path exported(const Project& project, const HandoverMeans& means = {}) {
        std::filesystem::remove_all(m_written);
        told = differencesOf(handoverOf(project), exporter(), means);
        exportProject(project, exporter(), m_written, means);
        return m_written / "organ.xml";
    }

    Differences told; ///< of what was written last
    TemporaryFolder m_folder;
    std::filesystem::path m_written = m_folder / "organ.mjcf";
};

/// Places and speeds that an organ comes to, and what pulls its nodes there; none where they cannot move.
struct MovedTissue {
    Vectors at, velocities, forces;

    template<class IsMovable>
    MovedTissue(const Project& project, Damping damping, const IsMovable& isMovable) {
        const SpringSystem system = makeSpringSystem(evaluateModel(project));
        const double size = organBox(*project.mesh, *project.network).diagonal().norm();
        std::mt19937 random(1);
        const auto scattered = [&](Eigen::Vector3d& vector, double by) {
            std::uniform_real_distribution<double> share(-by, by);
            vector += Eigen::Vector3d(share(random), share(random), share(random));
        };
        at = system.network->restPositions;
        velocities.assign(at.size(), Eigen::Vector3d::Zero());
        for (std::size_t node = 0; node < at.size(); ++node)
            if (isMovable(node)) {
                scattered(at[node], 0.02 * size);
                scattered(velocities[node], size);
            }
        forces.resize(at.size());
        elasticForces(system, at, forces);
        addDampingForces(system, damping, at, velocities, forces);
        for (std::size_t node = 0; node < at.size(); ++node)
            if (!isMovable(node)) forces[node].setZero();
    }
};

inline void expectSameForces(const Vectors& forces, const Vectors& expected, double tolerance = 1e-9) {
    double gap = 0, largest = 0;
    ASSERT_EQ(forces.size(), expected.size());
    for (std::size_t node = 0; node < forces.size(); ++node) {
        gap = std::max(gap, (forces[node] - expected[node]).norm());
        largest = std::max(largest, expected[node].norm());
    }
    ASSERT_GT(largest, 0);
    EXPECT_LT(gap, tolerance * largest);
}

} // namespace esm
