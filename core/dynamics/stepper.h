#pragma once

#include "core/dynamics/contact.h"
#include "core/dynamics/loads.h"
#include "core/dynamics/node_impulses.h"
#include "core/dynamics/stability.h"

#include <map>

namespace esm {

struct Motion {
    Vectors positions;  ///< m
    Vectors velocities; ///< m/s
};

/// Steps one spring system. With f the elastic forces, D the damping and g everything from outside, the step
/// h is
///   euler:  M·v⁺ = M·v + h·(f(x) − D·v + g),                      x⁺ = x + h·v⁺
///   split:  (M + h·D)·v⁺ = M·v + h·(f(x) + g),                    x⁺ = x + h·v⁺
///   split2: (3/2·M + h·D)·v⁺ = M·(2v − v⁻/2) + h·(2f − f⁻ + g),   x⁺ = (4x − x⁻ + 2h·v⁺)/3
/// split2 takes the form of split for the first step and after every jump: of loads or parameters, and while
/// nodes are led or touched.
class Stepper {
public:
    Stepper(SpringSystem system, std::vector<Triangle> surface, const ChosenStep& chosen, Damping damping);

    const SpringSystem& system() const { return m_system; }

    /// Precondition: the loads name nodes of the system. `sphere` is the instrument's way, if there is one.
    void step(Motion& motion, const Loads& loads, const std::optional<SphereMove>& sphere);

    /// Whether the sphere touched in the last step.
    bool isTouched() const { return m_touched; }

    /// Forgets what earlier steps left behind, as when the motion was changed from outside.
    void restart();

private:
    struct Solver {
        explicit Solver(StepMatrix&& factorised) : matrix(std::move(factorised)), impulses(matrix) {}
        StepMatrix matrix;
        NodeImpulses impulses;
    };
    struct Piece {
        double duration; ///< s
        int parts;       ///< the step's duration over this one's
        const Loads* loads;
        std::vector<HeldNode> held; ///< where they are at the end of the piece
        std::optional<SphereMove> sphere;
    };
    /// A step before anything touched it.
    struct Untouched {
        Vectors half;                   ///< half-solved velocities
        std::vector<std::uint32_t> led; ///< nodes led by impulses
    };

    std::vector<Piece> piecesOf(const Motion& motion, const Loads& loads,
                                const std::optional<SphereMove>& sphere) const;
    void advance(Motion& motion, const Piece& piece);
    Untouched solve(const Motion& motion, const Piece& piece, bool secondOrder, Motion& next);
    void moveOn(const Motion& motion, const Piece& piece, bool secondOrder, Motion& next) const;
    /// Pushes the surface out of the sphere. Precondition: `next` came from the first-order form.
    void makeWay(const Motion& motion, const Piece& piece, const Untouched& untouched, Motion& next);
    std::vector<char> immovable(const Piece& piece) const;
    bool touches(const Motion& motion, const Piece& piece, const Motion& next) const;
    Solver& solverFor(int parts, bool secondOrder);
    Vectors momentum(const Motion& motion, const Piece& piece, bool secondOrder) const;
    void prescribe(const std::vector<HeldNode>& held);

    SpringSystem m_system;
    std::vector<Triangle> m_surface;
    Integrator m_integrator;
    double m_timeStep; ///< s
    Damping m_damping;
    bool m_touched = false;

    std::vector<char> m_prescribed; ///< fixed nodes, and led ones when they are many
    std::map<std::pair<int, bool>, std::unique_ptr<Solver>> m_solvers; ///< by part and order

    std::optional<Loads> m_lastLoads;
    std::optional<Motion> m_previous;   ///< before the last step, when split2 may build on it
    Vectors m_forces, m_previousForces; ///< elastic, N
};

} // namespace esm
