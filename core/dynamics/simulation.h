#pragma once

#include "core/model/tissue_model.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// How time is stepped. `Auto` becomes one of the others when a simulation is made.
enum class Integrator { Auto, Euler, Split, Split2 };

/// The command line's name: auto, euler, split, split2.
const char* integratorName(Integrator integrator);
std::optional<Integrator> integratorFromName(const std::string& name);

enum class Damping { Isotropic, Axial };

struct SimulationSettings {
    Integrator integrator = Integrator::Auto;
    std::optional<double> timeStep;       ///< s; chosen safely without
    double longestStep = 0.01;            ///< s; what is chosen stays at or below this
    Damping damping = Damping::Isotropic; ///< split and split2 refuse axial
};

/// Every problem of the settings. Empty when they can be used.
std::vector<std::string> validate(const SimulationSettings& settings);

/// A sphere that pushes the surface out of its way. Within one step it may move 32 radii; moved farther, it
/// may pass through thin tissue. Where nothing can give way, as between fixed nodes, it passes.
struct Sphere {
    Eigen::Vector3d centre; ///< m
    double radius;          ///< m
};

/// A node led to a place; its velocity is what takes it there in one step.
struct HeldNode {
    std::uint32_t node;
    Eigen::Vector3d position; ///< m, at the end of the step
};

/// What acts on the tissue during one step.
struct Loads {
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();             ///< m/s²
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> forces; ///< node, N
    std::vector<HeldNode> held;
    std::optional<Sphere> instrument; ///< where it is at the end of the step
};

struct Energy {
    double kinetic = 0, elastic = 0; ///< J
};

/// A running model: the only thing in the program that is mutable and lives on. One thread at a time.
class Simulation {
public:
    /// Starts at rest. `surface` are the triangles over the nodes that an instrument touches; may be empty.
    /// @throws InvalidModel with every problem of model or settings (a step that is not above zero, split
    /// with axial damping, …)
    Simulation(const TissueModel& model, const SimulationSettings& settings,
               std::vector<Triangle> surface = {});
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();

    Integrator integrator() const;
    double timeStep() const;                                ///< s
    double time() const;                                    ///< s since the start
    const std::vector<Eigen::Vector3d>& positions() const;  ///< m, one per node
    const std::vector<Eigen::Vector3d>& velocities() const; ///< m/s
    Energy energy() const;

    /// Advances by one step. When the result is not finite or has left all bounds, the state before the step
    /// stays and false is returned; failure() then says why.
    bool step(const Loads& loads);
    const std::string& failure() const;

    /// Takes new parameters for the same network, the motion going on. @throws InvalidModel
    void setModel(const TissueModel& model);

    /// Back to rest at time 0.
    void reset();

private:
    struct Implementation;
    std::unique_ptr<Implementation> m_implementation;
};

} // namespace esm
