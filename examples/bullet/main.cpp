// Pokes an organ in Bullet and here, and says how far it goes another way there.
//
//     esm_in_bullet ORGAN.glb NODE FX FY FZ [SECONDS [STEP]]     a force on a node, N, for half of the time,
//     s
#include "bullet_organ.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

class OurOrgan {
public:
    OurOrgan(const EsmPackage* package, double timeStep) : m_numbers(3 * esmModelOf(package)->nodes.count) {
        const EsmSettings settings{"split2", timeStep, 0, 0, 1};
        m_simulation.reset(esmMakeSimulation(package, &settings, nullptr));
    }
    void step(double, const Poke& poke, bool acts) {
        esmSetForces(m_simulation.get(), acts, &poke.node, poke.force, nullptr);
        esmStep(m_simulation.get(), 1, nullptr);
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

} // namespace

int main(int count, char** words) {
    EsmError error{};
    const auto number = [&](int i, double otherwise) { return count > i ? std::atof(words[i]) : otherwise; };
    const Poke poke{
        uint32_t(number(2, 0)), {number(3, 0), number(4, 0), number(5, 0)}, number(6, 0.5), number(7, 1e-3)};
    const EsmPackage* const package =
        esmOpenPackage(count > 5 ? words[1] : nullptr, &error); // until the program ends
    const char* problem = package ? obstacle(*esmModelOf(package)) : error.text;
    if (!problem && poke.node >= esmModelOf(package)->nodes.count) problem = "there is no such node";
    if (problem) return std::fprintf(stderr, "%s\n", problem), 1;
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
