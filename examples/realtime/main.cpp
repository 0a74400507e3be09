// The loop of a simulator: an instrument goes into an organ and out again, and sixty times a second the
// tissue is as far as the clock.
//
//     esm_in_real_time ORGAN.glb [SECONDS]
//
// Where the machine is too slow for the step, tissue falls behind the clock instead of holding up the
// pictures.
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/exchange/package/packaged_tissue.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;
constexpr double frame = 1.0 / 60; // s

/// A ball a tenth as wide as the organ, that comes from beyond its largest x and pushes a tenth of its width
/// into it.
class Instrument {
public:
    explicit Instrument(const esm::PackagedTissue& package)
        : m_box(esm::organBox(package.mesh, *package.tissue.network)),
          m_radius(0.05 * m_box.diagonal().norm()) {}

    esm::PlacedCollider at(double time) const {
        constexpr double pi = 3.14159265358979323846;
        const double inwards = (0.05 - 0.05 * std::cos(2 * pi * time)) * m_box.diagonal().norm();
        return esm::sphereAt({m_box.max().x() + m_radius - inwards, m_box.center().y(), m_box.center().z()},
                             m_radius);
    }

private:
    Eigen::AlignedBox3d m_box;
    double m_radius;
};

/// Steps until the tissue is as far as `time`, s, or a picture is due; false where the motion ran wild.
bool catchUp(esm::Simulation& simulation, const Instrument& instrument, double time, Clock::time_point due) {
    while (simulation.time() + simulation.timeStep() <= time && Clock::now() < due) {
        esm::Loads loads;
        loads.instruments = {instrument.at(simulation.time() + simulation.timeStep())};
        if (!simulation.step(loads)) return false;
    }
    return true;
}

/// N, by which the tissue pushed the instrument back, on the mean since `before`.
double forceSince(const Eigen::Vector3d& before, const esm::Simulation& simulation, double seconds) {
    if (simulation.instrumentTouches().empty() || seconds <= 0) return 0;
    return (simulation.instrumentTouches()[0].impulse - before).norm() / seconds;
}

void showPicture(const esm::PackagedTissue& package, const esm::Simulation& simulation) {
    // A renderer uploads these vertices, and works out the normals of package.mesh.triangles.
    const auto vertices = esm::drawnPositions(package.mesh, *package.tissue.network, simulation.positions());
    (void)vertices;
}

int run(const esm::PackagedTissue& package, double seconds) {
    esm::Simulation simulation(package.tissue,
                               esm::steppedAsRecommended({}, package.tissue, package.stepping),
                               esm::touchedSurface(package.mesh, *package.tissue.network));
    std::printf("%s: %zu nodes, %s in steps of %g s\n", package.name.c_str(), simulation.positions().size(),
                esm::integratorName(simulation.integrator()), simulation.timeStep());
    const Instrument instrument(package);
    const Clock::time_point begin = Clock::now();
    double strongest = 0;
    for (int picture = 1; picture * frame <= seconds; ++picture) {
        const Clock::time_point due = begin + std::chrono::duration_cast<Clock::duration>(
                                                  std::chrono::duration<double>(picture * frame));
        const auto& touches = simulation.instrumentTouches();
        const Eigen::Vector3d before = touches.empty() ? Eigen::Vector3d(0, 0, 0) : touches[0].impulse;
        const double from = simulation.time();
        if (!catchUp(simulation, instrument, picture * frame, due))
            return std::fprintf(stderr, "%s\n", simulation.failure().c_str()), 1;
        strongest = std::max(strongest, forceSince(before, simulation, simulation.time() - from));
        showPicture(package, simulation);
        std::this_thread::sleep_until(due);
    }
    std::printf("%.0f %% of real time, at most %.3g N on the instrument\n", 100 * simulation.time() / seconds,
                strongest);
    return 0;
}

} // namespace

int main(int count, char** words) try {
    if (count < 2) return std::fprintf(stderr, "esm_in_real_time ORGAN.glb [SECONDS]\n"), 2;
    return run(esm::loadPackagedTissue(words[1]), count > 2 ? std::atof(words[2]) : 1);
} catch (const std::exception& problem) {
    return std::fprintf(stderr, "%s\n", problem.what()), 1;
}
