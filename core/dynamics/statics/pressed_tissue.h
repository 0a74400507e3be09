#pragma once

#include "core/dynamics/statics/inflated_tissue.h"
#include "core/dynamics/statics/least_tie.h"
#include "core/dynamics/statics/newton_way.h"
#include "core/dynamics/statics/resting_potential.h"
#include "core/dynamics/statics/sphere_contacts.h"
#include "core/dynamics/step_matrix.h"

#include <functional>
#include <optional>
#include <variant>

namespace esm {

/// A rigid sphere that goes along a line into tissue.
struct Indenter {
    double radius;           ///< m
    Eigen::Vector3d start;   ///< m, of its centre at depth 0
    Eigen::Vector3d inwards; ///< of length 1
};

/// What is given of an indenter: how deep it is, m, or how hard it is pushed, N, along its line. It does not
/// leave the line.
struct AtDepth {
    double depth;
};
struct UnderForce {
    double force; ///< above 0
};
using Drive = std::variant<AtDepth, UnderForce>;

/// Tissue beneath an indenter, found by balance: at rest, or after a step of time.
class PressedTissue {
public:
    /// At rest, the indenter at depth 0.
    /// @param system where parts that nothing holds are fixed; outlives this
    /// @param surface over the nodes, that the indenter touches
    /// @param checkpoint called now and then within long work; what it throws goes through
    PressedTissue(const SpringSystem& system, std::vector<Triangle> surface, const Indenter& indenter,
                  std::function<void()> checkpoint = {});
    /// The same at rest under pressures, which stay as they are.
    PressedTissue(const SpringSystem& system, const InflatedTissue& rest, std::vector<Triangle> surface,
                  const Indenter& indenter, std::function<void()> checkpoint = {});

    /// Where all forces cancel. @throws InvalidModel where no such place is found
    void settle(const Drive& drive);
    /// A time of `duration` (s) later, by the implicit Euler rule. @throws InvalidModel as settle()
    void step(const Drive& drive, double duration);

    double radius() const { return m_indenter.radius; }             ///< m
    double depth() const { return m_depth; }                        ///< m
    double force() const;                                           ///< N, of the sphere along its line
    const Vectors& positions() const { return m_motion.positions; } ///< m
    bool meetsImmovable() const { return m_contacts.meetsImmovable(); }

private:
    Eigen::Vector3d centre(double depth) const { return m_indenter.start + depth * m_indenter.inwards; }
    double potential(double depth, const Vectors& positions) const;
    void setLapse(std::optional<TimeLapse> lapse);
    void drive(const Drive& drive);
    void touch();
    void expect(const Vectors& change, double factor);
    void balance();
    void minimise(double tolerance);
    [[noreturn]] void findsNoBalance() const;
    double besidePushes(double force) const;
    double imbalance(const Vectors& forces) const;
    NewtonWay newtonWay(const Vectors& forces);
    std::optional<NewtonWay> newtonWay(const Vectors& forces, double tie);
    double slopeAlong(const NewtonWay& way, double depth, const Vectors& positions) const;
    bool go(const NewtonWay& way);

    const SpringSystem& m_system;
    Indenter m_indenter;
    std::function<void()> m_checkpoint;
    RestingPotential m_potential;
    SphereContacts m_contacts;
    Motion m_motion;
    Vectors m_perDepth;             ///< how places changed with the depth when it last settled
    double m_depth = 0;             ///< m
    std::optional<double> m_pushed; ///< N, where the force is given
    MatrixFactoriser m_factoriser;
    Vectors m_rowPlaces; ///< m, of the matrix' rows
    LeastTie m_tie;
    double m_stiffest = 0; ///< N/m, of all nodes
};

} // namespace esm
