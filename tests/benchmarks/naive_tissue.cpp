#include "tests/benchmarks/naive_tissue.h"

#include <cmath>

namespace benchmarks {

NaiveTissue::NaiveTissue(const esm::SpringSystem& system) {
    for (std::size_t i = 0; i < system.mass.size(); ++i) {
        const Eigen::Vector3d& p = system.network->restPositions[i];
        m_nodes.push_back({{p.x(), p.y(), p.z()}, {0, 0, 0}, {0, 0, 0}, system.mass[i]});
    }
    for (const auto& spring : system.springs)
        m_springs.push_back(
            {spring.first, spring.second, spring.restLength, spring.springConstant, spring.viscosity});
}

void NaiveTissue::step(double timeStep) {
    for (Node& node : m_nodes)
        node.force = {0, 0, 0};
    for (const Spring& spring : m_springs) {
        Node &a = m_nodes[spring.first], &b = m_nodes[spring.second];
        const double x = a.position.x - b.position.x, y = a.position.y - b.position.y,
                     z = a.position.z - b.position.z;
        const double elastic =
            spring.springConstant * (spring.restLength / std::sqrt(x * x + y * y + z * z) - 1);
        const Vector force{elastic * x - spring.viscosity * (a.velocity.x - b.velocity.x),
                           elastic * y - spring.viscosity * (a.velocity.y - b.velocity.y),
                           elastic * z - spring.viscosity * (a.velocity.z - b.velocity.z)};
        a.force.x += force.x;
        a.force.y += force.y;
        a.force.z += force.z;
        b.force.x -= force.x;
        b.force.y -= force.y;
        b.force.z -= force.z;
    }
    for (Node& node : m_nodes) {
        const double factor = timeStep / node.mass;
        node.velocity.x += factor * node.force.x;
        node.velocity.y += factor * node.force.y;
        node.velocity.z += factor * node.force.z;
        node.position.x += timeStep * node.velocity.x;
        node.position.y += timeStep * node.velocity.y;
        node.position.z += timeStep * node.velocity.z;
    }
}

} // namespace benchmarks
