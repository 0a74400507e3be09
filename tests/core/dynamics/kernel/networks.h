#pragma once

#include "core/dynamics/motion.h"
#include "tests/support/tissue_models.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>

/// Spring networks of every kind that the kernel must take.
namespace network {

using Eigen::Vector3d;
using esm::Motion, esm::SpringSystem;

/// Nodes of a gram at random places within 10 cm, without springs.
inline SpringSystem withNodes(std::size_t nodes) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> place(-0.05, 0.05);
    esm::SpringNetwork network;
    for (std::size_t i = 0; i < nodes; ++i)
        network.restPositions.emplace_back(place(generator), place(generator), place(generator));
    SpringSystem system;
    system.network = std::make_shared<const esm::SpringNetwork>(std::move(network));
    system.mass.assign(nodes, 0.001);
    system.fixed.assign(nodes, 0);
    return system;
}

inline void join(SpringSystem& system, std::uint32_t first, std::uint32_t second) {
    const auto& rest = system.network->restPositions;
    system.springs.push_back({first, second, (rest[first] - rest[second]).norm(), 10, 0.1});
}

struct Contents {
    std::size_t nodes = 200, springs = 700;
    bool biphasic = false;
    bool tethers = true, fixedNodes = true, zeroLength = true, hub = true;
    std::size_t hinges = 0;
};

/// Springs between random nodes, with random parameters; the last ten nodes are joined to nothing.
inline SpringSystem random(const Contents& contents, unsigned seed) {
    SpringSystem system = withNodes(contents.nodes);
    std::mt19937 generator(seed);
    const auto any = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator);
    };
    const auto last = static_cast<std::uint32_t>(contents.nodes - 11);
    std::uniform_int_distribution<std::uint32_t> node(0, last);
    while (system.springs.size() < contents.springs) {
        const std::uint32_t first = node(generator), second = node(generator);
        if (first != second) join(system, first, second);
    }
    if (contents.hub)
        for (std::uint32_t i = 1; i <= last; ++i)
            join(system, 0, i);
    for (auto& spring : system.springs) {
        spring.restLength *= any(0.5, 1.5);
        spring.springConstant = any(1, 30);
        spring.viscosity = any(0, 0.2);
        if (contents.biphasic && any(0, 1) < 0.7) spring.secondPhase = {any(0, 0.4), any(1, 200)};
    }
    for (double& mass : system.mass)
        mass = any(0.001, 0.01);
    for (std::uint32_t i = 0; i < contents.nodes; i += 3)
        if (contents.tethers) system.tethers.push_back({i, any(0, 5), any(0, 1)});
    if (contents.tethers) system.tethers.push_back({0, 2, 1});
    for (std::uint32_t i = 5; i < contents.nodes; i += 7)
        if (contents.fixedNodes) system.fixed[i] = 1;
    while (system.hinges.size() < contents.hinges) {
        const std::array nodes{node(generator), node(generator), node(generator), node(generator)};
        if (std::set(nodes.begin(), nodes.end()).size() < nodes.size()) continue;
        const std::array free{any(-1, 0), any(0, 1), any(0, 1)};
        system.hinges.push_back({nodes,
                                 {-free[0] - free[1] - free[2], free[0], free[1], free[2]},
                                 any(-20, 20),
                                 any(1, 30),
                                 any(0, 0.2)});
    }
    return system;
}

/// Away from rest; `zeroLength` puts the ends of every eleventh spring in one place.
inline Motion randomMotion(const SpringSystem& system, bool zeroLength, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> any(-0.01, 0.01);
    Motion motion{system.network->restPositions, esm::Vectors(system.mass.size(), Vector3d::Zero())};
    for (std::size_t i = 0; i < system.mass.size(); ++i) {
        motion.positions[i] += Vector3d(any(generator), any(generator), any(generator));
        if (!system.fixed[i])
            motion.velocities[i] = 10 * Vector3d(any(generator), any(generator), any(generator));
    }
    for (std::size_t i = 0; i < system.springs.size() && zeroLength; i += 11)
        motion.positions[system.springs[i].first] = motion.positions[system.springs[i].second];
    return motion;
}

inline std::vector<std::uint32_t> randomOrder(std::size_t nodes, unsigned seed) {
    std::vector<std::uint32_t> order(nodes);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    return order;
}

inline esm::Vectors renumbered(const esm::Vectors& values, const std::vector<std::uint32_t>& numbers) {
    esm::Vectors result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        result[numbers[i]] = values[i];
    return result;
}

/// The same network, its node i named numbers[i], its springs in another order.
inline SpringSystem renumbered(const SpringSystem& system, const std::vector<std::uint32_t>& numbers) {
    SpringSystem result = system;
    esm::SpringNetwork network;
    network.restPositions = renumbered(system.network->restPositions, numbers);
    result.network = std::make_shared<const esm::SpringNetwork>(std::move(network));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        result.mass[numbers[i]] = system.mass[i];
        result.fixed[numbers[i]] = system.fixed[i];
    }
    for (auto& spring : result.springs) {
        spring.first = numbers[spring.first];
        spring.second = numbers[spring.second];
    }
    std::shuffle(result.springs.begin(), result.springs.end(), std::mt19937(9));
    for (auto& hinge : result.hinges)
        for (std::uint32_t& node : hinge.nodes)
            node = numbers[node];
    std::shuffle(result.hinges.begin(), result.hinges.end(), std::mt19937(10));
    for (auto& tether : result.tethers)
        tether.node = numbers[tether.node];
    return result;
}

} // namespace network
