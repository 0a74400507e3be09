#include "tests/benchmarks/bullet.h"

#include "core/dynamics/stability/stability.h"
#include "tests/benchmarks/accuracy.h"
#include "tests/support/tissue_models.h"

#include <BulletSoftBody/btSoftBody.h>

#include <array>
#include <cstdio>

namespace benchmarks {

namespace {

constexpr int bulletRepetitions = 9;

btVector3 asBullet(const Eigen::Vector3d& v) {
    return {btScalar(v.x()), btScalar(v.y()), btScalar(v.z())};
}

/// What Bullet leaves to choose.
struct BulletSettings {
    double stiffness = 1; ///< of a link, 0 to 1
    double damping = 0;   ///< part of the velocity lost in a second
    int iterations = 1;
};

/// A network's springs as links of a soft body, nothing else touching it.
class BulletBody {
public:
    BulletBody(const esm::TissueModel& model, const BulletSettings& settings) {
        std::vector<btVector3> positions;
        for (const Eigen::Vector3d& position : model.network->restPositions)
            positions.push_back(asBullet(position));
        std::vector<btScalar> masses(model.mass.begin(), model.mass.end());
        for (const std::uint32_t node : model.fixedNodes)
            masses[node] = 0;
        m_world.m_gravity.setZero();
        m_body = std::make_unique<btSoftBody>(&m_world, static_cast<int>(positions.size()), positions.data(),
                                              masses.data());
        m_body->m_materials[0]->m_kLST = btScalar(settings.stiffness);
        for (const esm::Spring& spring : model.network->springs)
            m_body->appendLink(static_cast<int>(spring.first), static_cast<int>(spring.second));
        m_body->m_cfg.piterations = settings.iterations;
        m_body->m_cfg.kDP = btScalar(settings.damping);
    }

    void step(double timeStep) {
        m_body->predictMotion(btScalar(timeStep));
        m_body->solveConstraints();
        m_body->integrateMotion();
    }
    void pull(std::uint32_t node, const Eigen::Vector3d& force) {
        m_body->addForce(asBullet(force), static_cast<int>(node));
    }
    esm::Vectors positions() const {
        esm::Vectors result;
        for (int i = 0; i < m_body->m_nodes.size(); ++i) {
            const btVector3& position = m_body->m_nodes[i].m_x;
            result.emplace_back(position.x(), position.y(), position.z());
        }
        return result;
    }

private:
    btSoftBodyWorldInfo m_world;
    std::unique_ptr<btSoftBody> m_body;
};

struct BulletRun {
    BulletSettings settings;
    int steps;
};

void play(const PulledTissue& tissue, const BulletRun& run, esm::Trajectory* trajectory) {
    BulletBody body(tissue.model, run.settings);
    const int together = run.steps / frameCount;
    if (trajectory) trajectory->emplace(0, body.positions());
    for (int step = 1; step <= run.steps; ++step) {
        body.pull(tissue.node, tissue.force);
        body.step(tissue.seconds / run.steps);
        if (trajectory && step % together == 0) trajectory->emplace(step / together, body.positions());
    }
}

struct BestRun {
    BulletRun run;
    double error;
};

/// Of a grid of everything that can be chosen.
BestRun bestRun(const PulledTissue& tissue, const esm::Trajectory& reference) {
    BestRun best{{}, std::numeric_limits<double>::infinity()};
    for (const int steps : {frameCount, 4 * frameCount, 16 * frameCount, 64 * frameCount})
        for (const int iterations : {1, 3, 10})
            for (const double stiffness : {0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.7, 1.0})
                for (const double damping : {0.0, 0.001, 0.01}) {
                    const BulletRun run{{stiffness, damping, iterations}, steps};
                    esm::Trajectory found;
                    play(tissue, run, &found);
                    const double error = errorOf(found, reference);
                    if (error < best.error) best = {run, error};
                }
    return best;
}

/// A membrane in mid swing, neither stiff nor damped: what Bullet is good at.
struct EqualError {
    PulledTissue tissue = pulledMembrane(2000, 0, {0.02, 0.01, 0.05}, 0.2);
    esm::Trajectory reference = trajectoryOf(tissue, esm::Integrator::Rk4, frameCount << 7);
    BestRun best = bestRun(tissue, reference);
};

const EqualError& equalError() {
    static const EqualError found;
    return found;
}

std::function<void()> ourRun() {
    const auto& [tissue, reference, best] = equalError();
    const int steps = fewestSteps(tissue, esm::Integrator::Euler, best.error, reference);
    std::printf("Bullet's least error: %.3g with %d steps; euler takes %d\n", best.error, best.run.steps,
                steps);
    return [&tissue = tissue, steps] { trajectoryOf(tissue, esm::Integrator::Euler, steps); };
}

} // namespace

std::vector<Ratio> registerBullet() {
    std::vector<Ratio> ratios;
    for (const int iterations : {1, 10}) {
        const std::string name =
            "Bullet, 10 k, " + std::to_string(iterations) + (iterations == 1 ? " iteration" : " iterations");
        registerWork(name, bulletRepetitions, [iterations] {
            const auto body =
                std::make_shared<BulletBody>(tissue::fromMesh(tissue::sphereMesh(5, 0.05), {10, 0.01, 0.001}),
                                             BulletSettings{0.5, 0, iterations});
            body->pull(0, {0.1, 0, 0});
            return [body] { body->step(1e-3); };
        });
        const bool isOne = iterations == 1;
        ratios.push_back({name + " to float", name, "float, 10 k, 1 thread", Clock::Thread, isOne ? 6.0 : 0});
        ratios.push_back(
            {name + " to double", name, "double, 10 k, 1 thread", Clock::Thread, isOne ? 4.0 : 0});
    }
    registerWork("Bullet at its best error", bulletRepetitions, [] {
        const EqualError& found = equalError();
        return [&found] { play(found.tissue, found.best.run, nullptr); };
    });
    registerWork("euler at Bullet's best error", bulletRepetitions, ourRun);
    ratios.push_back({"Bullet at its best error to euler", "Bullet at its best error",
                      "euler at Bullet's best error", Clock::Thread, 8});
    return ratios;
}

} // namespace benchmarks
