#include "tests/benchmarks/explicit_step.h"

#include "core/dynamics/kernel/node_order.h"
#include "core/dynamics/kernel/tissue_kernel.h"
#include "tests/benchmarks/naive_tissue.h"
#include "tests/core/dynamics/kernel/networks.h"

#include <map>
#include <optional>

namespace benchmarks {

namespace {

using esm::SpringSystem;

constexpr double timeStep = 1e-3;        ///< s
constexpr int smallest = 3, largest = 8; ///< how often the triangles of an icosahedron are quartered
constexpr int repetitions = 15;

/// Bytes that one spring moves to and from memory, with the lines that are read before they are written.
template<class Real> constexpr double bytesPerSpring = sizeof(Real) == sizeof(float) ? 64 : 120;

std::string nodesText(int level) {
    const std::size_t nodes = (std::size_t{10} << (2 * level)) + 2;
    return nodes < 10000 ? std::to_string(nodes) : std::to_string(nodes / 1000) + " k";
}

double springCount(int level) {
    return static_cast<double>(std::size_t{30} << (2 * level));
}

/// A sphere in an order that suits a plain loop.
SpringSystem orderedSphere(int level) {
    const SpringSystem sphere =
        makeSpringSystem(tissue::fromMesh(tissue::sphereMesh(level, 0.05), {10, 0.01, 0.001}));
    std::vector<std::uint32_t> numbers(sphere.mass.size());
    std::uint32_t next = 0;
    for (const std::uint32_t node : esm::reverseCuthillMcKee(sphere))
        numbers[node] = next++;
    SpringSystem ordered = network::renumbered(sphere, numbers);
    std::sort(ordered.springs.begin(), ordered.springs.end(), [](const auto& a, const auto& b) {
        return std::pair(std::min(a.first, a.second), std::max(a.first, a.second)) <
               std::pair(std::min(b.first, b.second), std::max(b.first, b.second));
    });
    return ordered;
}

/// Spheres that are made when first needed.
class Spheres {
public:
    const SpringSystem& ordered(int level) {
        std::optional<SpringSystem>& sphere = m_ordered[level];
        if (!sphere) sphere = orderedSphere(level);
        return *sphere;
    }
    SpringSystem shuffled(int level) {
        const SpringSystem& sphere = ordered(level);
        return network::renumbered(sphere, network::randomOrder(sphere.mass.size(), 1));
    }

private:
    std::map<int, std::optional<SpringSystem>> m_ordered;
};

template<class Real> struct KernelRun {
    esm::TissueKernel<Real> kernel;
    typename esm::TissueKernel<Real>::State state, next;

    KernelRun(const SpringSystem& system, const esm::KernelOptions& options) : kernel(system, options) {
        esm::Vectors velocities(system.mass.size(), Eigen::Vector3d::Zero());
        velocities[0].x() = 0.1;
        state = next = kernel.load(system.network->restPositions, velocities);
    }
    void step() {
        kernel.step(state, next, {timeStep, Eigen::Vector3d::Zero()});
        state.swap(next);
    }
};

template<class Real>
std::function<void()> steps(const SpringSystem& system, const esm::KernelOptions& options) {
    return [run = std::make_shared<KernelRun<Real>>(system, options)] { run->step(); };
}

/// a = b + s·c over arrays far larger than any cache.
class Triad {
public:
    explicit Triad(std::shared_ptr<esm::ThreadTeam> team) : m_team(std::move(team)) {}

    static constexpr double bytes() { return 4.0 * sizeof(double) * static_cast<double>(length); }

    void pass(std::size_t threads) {
        m_team->run(threads, [&](std::size_t part) {
            double* const a = m_a.data();
            const double *const b = m_b.data(), *const c = m_c.data();
            for (std::size_t i = length * part / threads; i < length * (part + 1) / threads; ++i)
                a[i] = b[i] + 3 * c[i];
        });
        benchmark::ClobberMemory();
    }

private:
    static constexpr std::size_t length = 8 << 20;
    std::shared_ptr<esm::ThreadTeam> m_team;
    esm::LargeVector<double> m_a = esm::LargeVector<double>(length), m_b = m_a, m_c = m_a;
};

template<class Real>
void registerSphere(const std::string& name, int level, const std::shared_ptr<Spheres>& spheres,
                    const std::shared_ptr<esm::ThreadTeam>& team) {
    using esm::Damping, esm::InstructionSet;
    const auto add = [&](const std::string& variant, const esm::KernelOptions& options) {
        registerWork(name + variant, repetitions,
                     [=] { return steps<Real>(spheres->ordered(level), options); });
    };
    add(", 1 thread", {});
    add(", x86-64-v2", {Damping::Isotropic, InstructionSet::V2});
    add(", 2 threads", {Damping::Isotropic, {}, team.get(), 2});
    add(", threads by size", {Damping::Isotropic, {}, team.get()});
    registerWork(name + ", shuffled", repetitions, [=] { return steps<Real>(spheres->shuffled(level), {}); });
}

template<class Real> void addRatios(const std::string& precision, int level, std::vector<Ratio>& ratios) {
    const std::string nodes = nodesText(level), name = precision + ", " + nodes;
    const std::string alone = name + ", 1 thread", two = name + ", 2 threads";
    const double aim = sizeof(Real) == sizeof(float) ? 0.35 : 0.6;
    const bool isMiddle = level == 5 || level == 6;
    ratios.push_back(
        {name + ": to the naive loop", alone, "naive, " + nodes, Clock::Thread, 0, isMiddle ? aim : 0});
    ratios.push_back(
        {name + ": x86-64-v2 to the naive loop", name + ", x86-64-v2", "naive, " + nodes, Clock::Thread});
    ratios.push_back({name + ": shuffled to ordered", name + ", shuffled", alone, Clock::Thread, 0, 1.15});
    ratios.push_back({name + ": 1 thread to 2", alone, two, Clock::Wall, level >= 4 && level <= 7 ? 1.7 : 0});
    ratios.push_back(
        {name + ": threads by size to 1", name + ", threads by size", alone, Clock::Wall, 0, 1.1});
    const std::string tenThousand = precision + ", " + nodesText(5) + ", 1 thread";
    ratios.push_back({name + ": a spring to one of 10 k", alone, tenThousand, Clock::Thread, 0, 0,
                      springCount(5) / springCount(level)});
    if (level < largest) return;
    const double bytes = bytesPerSpring<Real> * springCount(level) / Triad::bytes();
    ratios.push_back(
        {name + ": bandwidth to triad, 1 thread", "triad, 1 thread", alone, Clock::Thread, 0.7, 0, bytes});
    ratios.push_back(
        {name + ": bandwidth to triad, 2 threads", "triad, 2 threads", two, Clock::Wall, 0.7, 0, bytes});
}

} // namespace

std::vector<Ratio> registerExplicitStep() {
    std::vector<Ratio> ratios;
    const auto spheres = std::make_shared<Spheres>();
    const auto team = std::make_shared<esm::ThreadTeam>(2);
    for (int level = smallest; level <= largest; ++level) {
        const std::string nodes = nodesText(level);
        registerWork("naive, " + nodes, repetitions, [=] {
            const auto naive = std::make_shared<NaiveTissue>(spheres->ordered(level));
            return [naive] { naive->step(timeStep); };
        });
        registerSphere<float>("float, " + nodes, level, spheres, team);
        registerSphere<double>("double, " + nodes, level, spheres, team);
        addRatios<float>("float", level, ratios);
        addRatios<double>("double", level, ratios);
    }
    const auto triad = std::make_shared<Triad>(team);
    registerWork("triad, 1 thread", repetitions, [triad] { return [triad] { triad->pass(1); }; });
    registerWork("triad, 2 threads", repetitions, [triad] { return [triad] { triad->pass(2); }; });
    return ratios;
}

} // namespace benchmarks
