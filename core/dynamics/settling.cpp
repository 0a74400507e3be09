#include "core/dynamics/settling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace esm {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A way that a node is held by: through a spring, from a neighbour that is held itself, or by a tether.
struct Hold {
    std::uint32_t node;
    Settling settling;
};

struct IsSlower {
    bool operator()(const Hold& a, const Hold& b) const { return a.settling.waveTime > b.settling.waveTime; }
};

/// The springs at each node.
class SpringsAtNodes {
public:
    explicit SpringsAtNodes(const SpringSystem& system) : m_starts(system.mass.size() + 1, 0) {
        for (const auto& spring : system.springs)
            for (const std::uint32_t node : {spring.first, spring.second})
                ++m_starts[node + 1];
        for (std::size_t node = 0; node < system.mass.size(); ++node)
            m_starts[node + 1] += m_starts[node];
        std::vector<std::size_t> next(m_starts.begin(), m_starts.end() - 1);
        m_springs.resize(m_starts.back());
        for (std::uint32_t i = 0; i < system.springs.size(); ++i)
            for (const std::uint32_t node : {system.springs[i].first, system.springs[i].second})
                m_springs[next[node]++] = i;
    }
    template<class Visit> void visit(std::uint32_t node, const Visit& visit) const {
        for (std::size_t i = m_starts[node]; i < m_starts[node + 1]; ++i)
            visit(m_springs[i]);
    }

private:
    std::vector<std::size_t> m_starts;
    std::vector<std::uint32_t> m_springs;
};

/// N·s/m, sums at each node. Moved across flat tissue, a node meets the viscosity of all its springs,
/// whatever brings it back.
std::vector<double> viscositiesAtNodes(const SpringSystem& system) {
    std::vector<double> sums(system.mass.size(), 0);
    for (const auto& spring : system.springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            sums[node] += spring.viscosity;
    for (const Tether& tether : system.tethers)
        sums[tether.node] += tether.viscosity;
    return sums;
}

/// N/m, where the spring is softest and settles the slowest.
double leastSpringConstant(const SpringSystem::Element& spring) {
    return spring.stiffening.isLinear() ? spring.springConstant
                                        : std::min(spring.springConstant, spring.stiffening.springConstant);
}

} // namespace

// Dijkstra's way from all holds at once, a spring as long as a wave takes to pass it.
std::vector<Settling> settlingOf(const SpringSystem& system) {
    std::vector<Settling> nodes(system.mass.size(), {never, never});
    const std::vector<double> viscosity = viscositiesAtNodes(system);
    std::priority_queue<Hold, std::vector<Hold>, IsSlower> waiting;
    const auto settle = [&](std::uint32_t node, const Settling& settling) {
        if (!(settling.waveTime < nodes[node].waveTime)) return;
        nodes[node] = settling;
        waiting.push({node, settling});
    };
    const auto hang = [&](std::uint32_t node, const Settling& hold, double springConstant) {
        settle(node, {hold.waveTime + std::sqrt(system.mass[node] / springConstant),
                      std::max(hold.driftTime, viscosity[node] / springConstant)});
    };
    for (std::uint32_t node = 0; node < nodes.size(); ++node)
        if (system.fixed[node]) settle(node, {0, 0});
    for (const Tether& tether : system.tethers)
        hang(tether.node, {0, 0}, tether.springConstant);

    const SpringsAtNodes springs(system);
    while (!waiting.empty()) {
        const auto [node, settling] = waiting.top();
        waiting.pop();
        if (settling.waveTime > nodes[node].waveTime) continue;
        springs.visit(node, [&, &from = node, &reached = settling](std::uint32_t index) {
            const auto& spring = system.springs[index];
            hang(spring.first == from ? spring.second : spring.first, reached, leastSpringConstant(spring));
        });
    }
    return nodes;
}

} // namespace esm
