// A model package as a soft body of Bullet (3.24).
//
// Bullet's older soft bodies know no spring constants: a link has a stiffness from 0 to 1, which means
// another one for each step and number of iterations. The deformable ones, taken here, have
// btDeformableMassSpringForce: a spring constant, and a viscosity that damps all of the relative velocity
// where momentum_conserving is false. With setImplicit(false) they step as our "split" does. They cannot
// carry springs of different values, as regions and even sheets have, tethers, springs that stiffen, hinges,
// fluid, forces on single nodes (added to velocities here), or a surface over fewer nodes.
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <esm_package.h>

#include <algorithm>
#include <memory>
#include <vector>

using Positions = std::vector<double>; // m, x, y, z of every node

struct Poke {
    uint32_t node;
    double force[3];      // N, in the first half of the time
    double seconds, step; // s
};

/// Whether springs are all alike.
inline bool isOne(const double* values, size_t count) {
    const auto [least, most] = std::minmax_element(values, values + count);
    return count > 0 && *most - *least <= 1e-6 * *most;
}

/// Why Bullet would move it as something else; null where it can move it.
inline const char* obstacle(const EsmModel& model) {
    if (!isOne(model.springs.springConstants, model.springs.count) ||
        !isOne(model.springs.viscosities, model.springs.count))
        return "its springs are not all alike (import with --springs alike, and one tissue)";
    if (model.tethers.count > 0) return "it has tethers (hold it by fixed nodes instead)";
    if (model.stiffening.strain == 0 && model.hinges.count == 0 && model.fillings.count == 0) return nullptr;
    return "it stiffens, resists bending or is filled with fluid";
}

class BulletOrgan {
public:
    explicit BulletOrgan(const EsmModel& model)
        : m_springs(model.springs.springConstants[0], model.springs.viscosities[0], false) {
        m_constraints.setDeformableSolver(&m_solver);
        m_world.setGravity({0, 0, 0});
        m_world.setImplicit(false);
        std::vector<btVector3> places;
        for (const double* p = model.nodes.restPositions; places.size() < model.nodes.count; p += 3)
            places.emplace_back(p[0], p[1], p[2]);
        m_body = std::make_unique<btSoftBody>(&m_world.getWorldInfo(), int(places.size()), places.data(),
                                              model.nodes.masses);
        for (size_t i = 0; i < model.fixedNodes.count; ++i)
            m_body->setMass(int(model.fixedNodes.nodes[i]), 0);
        for (size_t i = 0; i < model.springs.count; ++i) {
            m_body->appendLink(int(model.springs.nodes[2 * i]), int(model.springs.nodes[2 * i + 1]));
            m_body->m_links[int(i)].m_rl = model.springs.restLengths[i];
        }
        m_body->m_cfg.collisions = 0;
        m_body->setActivationState(DISABLE_DEACTIVATION); // slow motion would be taken for sleep
        m_world.addSoftBody(m_body.get());
        m_world.addForce(m_body.get(), &m_springs);
    }
    ~BulletOrgan() { m_world.removeSoftBody(m_body.get()); }

    void step(double seconds, const Poke& poke, bool acts) {
        btSoftBody::Node& node = m_body->m_nodes[int(poke.node)];
        if (acts) node.m_v += seconds * node.m_im * btVector3(poke.force[0], poke.force[1], poke.force[2]);
        m_world.stepSimulation(seconds, 0);
    }
    Positions positions() const {
        Positions result;
        for (int i = 0; i < 3 * m_body->m_nodes.size(); ++i)
            result.push_back(m_body->m_nodes[i / 3].m_x[i % 3]);
        return result;
    }

private:
    btSoftBodyRigidBodyCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btDeformableBodySolver m_solver;
    btDeformableMultiBodyConstraintSolver m_constraints;
    btDeformableMultiBodyDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_constraints, &m_configuration,
                                               &m_solver};
    btDeformableMassSpringForce m_springs;
    std::unique_ptr<btSoftBody> m_body;
};
