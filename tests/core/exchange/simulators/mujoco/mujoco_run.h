#pragma once

#include <Eigen/Core>
#include <mujoco/mujoco.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace esm {

/// An organ in MuJoCo itself.
class MujocoRun {
public:
    using Vectors = std::vector<Eigen::Vector3d>; ///< one per node

    explicit MujocoRun(const std::filesystem::path& file) {
        mju_user_warning = [](const char*) {}; // else it writes a log into the working folder
        char problem[1000] = "";
        m_model.reset(mj_loadXML(file.c_str(), nullptr, problem, sizeof problem));
        if (!m_model || *problem != '\0') throw std::runtime_error(problem);
        m_data.reset(mj_makeData(m_model.get()));
        if (!m_data) throw std::runtime_error("MuJoCo has no room for it");
        mj_forward(m_model.get(), m_data.get());
        m_rest = places();
    }

    std::size_t nodeCount() const { return static_cast<std::size_t>(m_model->nbody) - 1; } // the world is one
    bool isMovable(std::size_t node) const { return m_model->body_jntnum[node + 1] == 3; }
    double timeStep() const { return m_model->opt.timestep; }
    void setTimeStep(double step) { m_model->opt.timestep = step; }

    Vectors places() const {
        mj_kinematics(m_model.get(), m_data.get());
        Vectors places;
        for (std::size_t node = 0; node < nodeCount(); ++node)
            places.emplace_back(Eigen::Map<const Eigen::Vector3d>(m_data->xpos + 3 * (node + 1)));
        return places;
    }

    Vectors velocities() const {
        Vectors velocities(nodeCount(), Eigen::Vector3d::Zero());
        for (std::size_t node = 0; node < nodeCount(); ++node)
            if (isMovable(node)) velocities[node] = vectorOf(m_data->qvel, node);
        return velocities;
    }

    /// N, of springs and damping of joints and tendons.
    Vectors forces(const Vectors& at, const Vectors& velocities) {
        for (std::size_t node = 0; node < nodeCount(); ++node) {
            if (!isMovable(node)) continue;
            vectorOf(m_data->qpos, node) = at[node] - m_rest[node];
            vectorOf(m_data->qvel, node) = velocities[node];
        }
        mj_forward(m_model.get(), m_data.get());
        Vectors forces(nodeCount(), Eigen::Vector3d::Zero());
        for (std::size_t node = 0; node < nodeCount(); ++node)
            if (isMovable(node)) forces[node] = vectorOf(m_data->qfrc_passive, node);
        return forces;
    }

    void setForce(std::size_t node, const Eigen::Vector3d& force) {
        vectorOf(m_data->qfrc_applied, node) = force;
    }

    /// False once it has blown up: MuJoCo warns and starts anew.
    bool step() {
        mj_step(m_model.get(), m_data.get());
        for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
            if (m_data->warning[warning].number > 0) return false;
        return true;
    }

private:
    struct Delete {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
        void operator()(mjData* data) const { mj_deleteData(data); }
    };

    Eigen::Map<Eigen::Vector3d> vectorOf(mjtNum* values, std::size_t node) const {
        return Eigen::Map<Eigen::Vector3d>(values + m_model->jnt_dofadr[m_model->body_jntadr[node + 1]]);
    }

    std::unique_ptr<mjModel, Delete> m_model;
    std::unique_ptr<mjData, Delete> m_data;
    Vectors m_rest;
};

} // namespace esm
