#include "core/dynamics/settling.h"

#include "core/dynamics/node_ties.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace esm {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// How a node is held: through a spring, from a neighbour that is held itself, or by a tether (then from
/// itself).
struct Hold {
    std::uint32_t node, from;
    double waveTime;       ///< s
    double springConstant; ///< N/m
};

struct IsSlower {
    bool operator()(const Hold& a, const Hold& b) const { return a.waveTime > b.waveTime; }
};

/// N·s/m, sums at each node. Moved across flat tissue, a node meets the viscosity of all its springs,
/// whatever brings it back.
std::vector<double> springViscosities(const SpringSystem& system) {
    std::vector<double> sums(system.mass.size(), 0);
    for (const auto& spring : system.springs)
        for (const std::uint32_t node : {spring.first, spring.second})
            sums[node] += spring.viscosity;
    return sums;
}

/// N·s/m, what each node meets of its surroundings, however the tissue around it moves.
std::vector<double> tetherViscosities(const SpringSystem& system) {
    std::vector<double> sums(system.mass.size(), 0);
    for (const Tether& tether : system.tethers)
        sums[tether.node] += tether.viscosity;
    return sums;
}

/// N/m, where the spring is softest and settles the slowest.
double leastSpringConstant(const SpringSystem::Element& spring) {
    return spring.secondPhase.isLinear() ? spring.springConstant
                                         : std::min(spring.springConstant, spring.secondPhase.springConstant);
}

// Each node's fastest hold, in the order of the time that a wave takes to it: Dijkstra's way (1959) from all
// holds at once, a spring as long as a wave takes to pass it. Along a row of like masses and springs a wave
// passes one of them in √(m/c). What a queue still holds of a node that was reached faster since is passed
// over.
std::vector<Hold> fastestHolds(const SpringSystem& system) {
    std::vector<double> waveTimes(system.mass.size(), never);
    std::vector<Hold> holds;
    std::priority_queue<Hold, std::vector<Hold>, IsSlower> waiting;
    const auto offer = [&](const Hold& hold) {
        if (!(hold.waveTime < waveTimes[hold.node])) return;
        waveTimes[hold.node] = hold.waveTime;
        waiting.push(hold);
    };
    const auto hang = [&](std::uint32_t node, std::uint32_t from, double since, double springConstant) {
        offer({node, from, since + std::sqrt(system.mass[node] / springConstant), springConstant});
    };
    for (std::uint32_t node = 0; node < waveTimes.size(); ++node)
        if (system.fixed[node]) offer({node, node, 0, never});
    for (const Tether& tether : system.tethers)
        hang(tether.node, tether.node, 0, tether.springConstant);

    const NodeTies ties(system);
    while (!waiting.empty()) {
        const Hold hold = waiting.top();
        waiting.pop();
        if (hold.waveTime > waveTimes[hold.node]) continue;
        holds.push_back(hold);
        for (const auto& [neighbour, spring] : ties.springsOf(hold.node))
            hang(neighbour, hold.node, hold.waveTime, leastSpringConstant(system.springs[spring]));
    }
    return holds;
}

} // namespace

// How long a slow motion takes depends on what slows it. A damper between two nodes slows its own spring,
// which settles in d/c whatever the others do: of these times the longest on the way to the hold counts. A
// damper to the surroundings drags at its node, and each spring of the way has to bring back all that hangs
// on it, as a line of resistors charges its capacitors: these times add up along the way (Elmore's bound,
// 1948). A hundred nodes in a row take thousands of times as long as one of them.
std::vector<Settling> settlingOf(const SpringSystem& system) {
    std::vector<Settling> nodes(system.mass.size(), {never, never});
    const std::vector<Hold> holds = fastestHolds(system);
    std::vector<double> hanging = tetherViscosities(system);
    for (auto hold = holds.rbegin(); hold != holds.rend(); ++hold)
        if (hold->from != hold->node) hanging[hold->from] += hanging[hold->node];

    const std::vector<double> viscosity = springViscosities(system);
    std::vector<double> slowest(nodes.size(), 0), dragged(nodes.size(), 0); // s
    for (const auto& [node, from, waveTime, springConstant] : holds) {
        slowest[node] = std::max(slowest[from], viscosity[node] / springConstant);
        dragged[node] = dragged[from] + hanging[node] / springConstant;
        nodes[node] = {waveTime, slowest[node] + dragged[node]};
    }
    return nodes;
}

} // namespace esm
