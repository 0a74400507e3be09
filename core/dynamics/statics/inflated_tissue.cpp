#include "core/dynamics/statics/inflated_tissue.h"

#include "core/dynamics/bursting.h"
#include "core/dynamics/forces.h"
#include "core/dynamics/statics/balance.h"
#include "core/dynamics/statics/newton_descent.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double firstRise = 0.25;       ///< of the pressures
constexpr double leastRise = 1.0 / 64;   ///< by which they are raised
constexpr double farthestSwelling = 0.1; ///< of the tissue's size, that a node goes in one step
/// Of the tissue's size: less than what moves the stiffest node so far is no force.
constexpr double leastSwelling = 1e-6;

/// Tissue while its pressures rise.
class Inflation {
public:
    Inflation(const SpringSystem& system, const std::vector<CavityPressure>& pressures,
              const Progress& progress)
        : m_system(system), m_pressures(pressures), m_progress(progress), m_potential(system),
          m_descent(system, m_potential), m_positions(system.network->restPositions),
          m_size(boundingBox(m_positions).diagonal().norm()) {}

    void fill();
    Vectors takePositions() { return std::move(m_positions); }

private:
    bool rise(double share);
    double imbalance(const Vectors& positions, const Vectors& forces) const;
    [[noreturn]] void findsNoBalance() const;

    const SpringSystem& m_system;
    const std::vector<CavityPressure>& m_pressures; ///< all of them
    Loads m_acting;                                 ///< the share that is tried
    const Progress& m_progress;
    RestingPotential m_potential;
    NewtonDescent m_descent;
    Vectors m_positions; ///< m, at rest under the share of the pressures
    double m_size;       ///< m, of all of it at rest
    double m_share = 0;
    std::string m_burst; ///< what burst when the pressures last rose too far
};

// A soft wall's way from rest is long, and near its end next to nothing holds it back. From too far away
// Newton's method may step over the place of rest to where a wall of linear springs holds no pressure at all
// and grows for ever. From rest under a little less it comes to it from below, where the tension still rises
// faster than further on, so that each step falls short. Hence shares of the pressure, as large as go well.
void Inflation::fill() {
    double step = firstRise;
    while (m_share < 1) {
        reportProgress(m_progress, m_share);
        step = std::min(step, 1 - m_share);
        if (rise(m_share + step)) {
            m_share += step;
            step *= 2;
        } else if (step <= leastRise) {
            findsNoBalance();
        } else {
            step = std::max(step / 4, leastRise);
        }
    }
}

/// Whether it comes to rest under that share; else it stays where it is.
bool Inflation::rise(double share) {
    m_acting.pressures = m_pressures;
    for (CavityPressure& pressure : m_acting.pressures)
        pressure.before = pressure.after = share * pressure.after;
    m_potential.setPressures(m_acting.pressures);
    Vectors positions = m_positions, forces;
    m_burst.clear();
    const auto left = [&] {
        reportProgress(m_progress, m_share);
        m_potential.forces(positions, forces);
        return imbalance(positions, forces);
    };
    const auto go = [&] {
        if (!m_descent.go(m_potential, forces, positions, farthestSwelling * m_size)) return false;
        m_burst = burstOf(m_system, positions);
        return m_burst.empty();
    };
    if (!findRest(balanced, left, go) || !m_burst.empty()) return false;
    m_positions = std::move(positions);
    return true;
}

/// What forces leave over, of what the pressures do to a node.
double Inflation::imbalance(const Vectors& positions, const Vectors& forces) const {
    Vectors pushes(positions.size(), Eigen::Vector3d::Zero());
    addPressureOfLoads(m_system, m_acting, 0, positions, pushes);
    double left = 0, pushed = leastSwelling * m_size * m_descent.stiffest();
    for (std::size_t i = 0; i < forces.size(); ++i) {
        left = std::max(left, forces[i].norm());
        if (!m_system.fixed[i]) pushed = std::max(pushed, pushes[i].norm());
    }
    return left / pushed;
}

void Inflation::findsNoBalance() const {
    const std::string borne =
        m_share > 0 ? "; it bears at least " + percentText(m_share) + " of this pressure" : std::string();
    if (!m_burst.empty()) throw InvalidModel(m_burst + borne);
    const bool bendsFreely = m_system.hinges.empty();
    throw InvalidModel(std::string("the organ finds no balance under the pressure within it: choose one "
                                   "nearer to 0") +
                       (bendsFreely ? ", or let the surface resist bending, without which it folds in many "
                                      "ways of nearly the same energy"
                                    : "") +
                       borne);
}

} // namespace

InflatedTissue inflated(const SpringSystem& system, std::vector<CavityPressure> pressures,
                        const Progress& progress) {
    Vectors positions = system.network->restPositions;
    if (std::any_of(pressures.begin(), pressures.end(),
                    [](const CavityPressure& pressure) { return pressure.after != 0; })) {
        Inflation inflation(system, pressures, progress);
        inflation.fill();
        positions = inflation.takePositions();
    }
    reportProgress(progress, 1);
    return {std::move(positions), std::move(pressures)};
}

} // namespace esm
