#pragma once

#include "core/dynamics/spring_system.h"

namespace benchmarks {

/// What the kernel is compared with: semi-implicit Euler as one writes it at first. Nodes and springs are
/// structures in arrays; one loop over the springs adds forces to both ends, one over the nodes moves them.
class NaiveTissue {
public:
    explicit NaiveTissue(const esm::SpringSystem& system);
    void step(double timeStep);

private:
    struct Vector {
        double x, y, z;
    };
    struct Node {
        Vector position, velocity, force;
        double mass;
    };
    struct Spring {
        std::uint32_t first, second;
        double restLength, springConstant, viscosity;
    };

    std::vector<Node> m_nodes;
    std::vector<Spring> m_springs;
};

} // namespace benchmarks
