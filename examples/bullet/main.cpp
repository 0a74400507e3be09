// Pokes an organ in Bullet and here, and says how far it goes another way there.
//
//     esm_in_bullet ORGAN.glb NODE FX FY FZ [SECONDS [STEP]]
//
// A force on a node, N, for half of the time, s.
#include "bullet_organ.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

namespace {

class OurOrgan {
public:
    OurOrgan(const EsmPackage* package, double timeStep) : m_numbers(3 * esmModelOf(package)->nodes.count) {
        const EsmSettings settings{"split2", timeStep, 0, 0, 1};
        EsmError error;
        m_simulation.reset(esmMakeSimulation(package, &settings, &error));
        if (!m_simulation) throw std::runtime_error(error.text);
    }
    void step(double, const Poke& poke, bool acts) {
        EsmError error;
        if (!esmSetForces(m_simulation.get(), acts, &poke.node, poke.force, &error) ||
            esmStep(m_simulation.get(), 1, &error) < 1)
            throw std::runtime_error(error.text);
    }
    Positions positions() const {
        const double* const first = esmPositionsOf(m_simulation.get());
        return {first, first + m_numbers};
    }

private:
    size_t m_numbers; // of positions
    std::unique_ptr<EsmSimulation, decltype(&esmFreeSimulation)> m_simulation{nullptr, &esmFreeSimulation};
};

/// Where the nodes are at fifty times. @param steps between two of these
template<class Organ>
std::vector<Positions> motionOf(const char* name, Organ&& organ, const Poke& poke, int steps) {
    constexpr int frames = 50;
    const double step = poke.seconds / frames / steps;
    std::vector<Positions> motion;
    const std::clock_t begin = std::clock();
    for (int i = 0; i < frames * steps; ++i) {
        organ.step(step, poke, 2 * i < frames * steps);
        if ((i + 1) % steps == 0) motion.push_back(organ.positions());
    }
    const double computed = double(std::clock() - begin) / CLOCKS_PER_SEC / poke.seconds;
    std::printf("%s: %.3g s of computing for each second, in steps of %.3g s\n", name, computed, step);
    return motion;
}

/// In percent of the motion itself.
double difference(const std::vector<Positions>& motion, const std::vector<Positions>& reference,
                  const double* rest) {
    double off = 0, moved = 0;
    for (size_t i = 0; i < motion.size() * motion[0].size(); ++i) {
        const size_t frame = i / motion[0].size(), k = i % motion[0].size();
        off += std::pow(motion[frame][k] - reference[frame][k], 2);
        moved += std::pow(reference[frame][k] - rest[k], 2);
    }
    return 100 * std::sqrt(off / moved);
}

/// What the command line says of a poke. @throws std::runtime_error
Poke pokeOf(int count, char** words, size_t nodes) {
    const auto number = [&](int i, double otherwise) { return count > i ? std::atof(words[i]) : otherwise; };
    const double node = number(2, 0), seconds = number(6, 0.5), step = number(7, 1e-3);
    if (!(node >= 0 && node < double(nodes))) throw std::runtime_error("there is no such node");
    if (!(seconds > 0 && step > 0 && seconds / step < 1e6))
        throw std::runtime_error("SECONDS and STEP must be above 0, and be less than a million steps");
    return {uint32_t(node), {number(3, 0), number(4, 0), number(5, 0)}, seconds, step};
}

void compare(const EsmPackage* package, const Poke& poke) {
    const EsmModel& model = *esmModelOf(package);
    const int steps = std::max(1, int(std::lround(poke.seconds / 50 / poke.step)));
    const auto ours = [&](const char* name, int finer) {
        return motionOf(name, OurOrgan(package, poke.seconds / 50 / steps / finer), poke, steps * finer);
    };
    const auto bullet = motionOf("Bullet", BulletOrgan(model), poke, steps);
    const auto like = ours("ours, split2", 1), reference = ours("reference", 16);
    const double* const rest = model.nodes.restPositions;
    std::printf("off by %.3g %% of the motion, ours by %.3g %%\n", difference(bullet, reference, rest),
                difference(like, reference, rest));
}

} // namespace

int main(int count, char** words) try {
    if (count < 6) throw std::runtime_error("esm_in_bullet ORGAN.glb NODE FX FY FZ [SECONDS [STEP]]");
    EsmError error;
    const std::unique_ptr<EsmPackage, decltype(&esmFreePackage)> package(esmOpenPackage(words[1], &error),
                                                                         &esmFreePackage);
    if (!package) throw std::runtime_error(error.text);
    const EsmModel& model = *esmModelOf(package.get());
    if (const char* problem = obstacle(model)) throw std::runtime_error(problem);
    compare(package.get(), pokeOf(count, words, model.nodes.count));
} catch (const std::exception& problem) {
    return std::fprintf(stderr, "%s\n", problem.what()), 1;
}
