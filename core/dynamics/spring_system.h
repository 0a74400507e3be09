#pragma once

#include "core/dynamics/cavity_wall.h"
#include "core/dynamics/spring_law.h"
#include "core/model/tissue_model.h"

#include <array>
#include <memory>
#include <vector>

namespace esm {

using Vectors = std::vector<Eigen::Vector3d>; ///< one per node

/// A tissue model laid out for stepping: each spring has its values, fixed nodes are flags.
struct SpringSystem {
    struct Element {
        std::uint32_t first, second;
        double restLength;     ///< m
        double springConstant; ///< N/m
        double viscosity;      ///< N·s/m
        SecondPhase secondPhase{};
    };

    /// A spring between the two bars of a hinge, see HingeShape.
    struct HingeElement {
        std::array<std::uint32_t, 4> nodes;
        std::array<double, 4> weights;
        double restCurvature;  ///< 1/m
        double springConstant; ///< N/m
        double viscosity;      ///< N·s/m
    };

    /// A cavity: within it a pressure of stiffness·(V₀ − V)/V₀, and what loads lay on it.
    struct Filled {
        std::uint32_t part;
        double stiffness;       ///< Pa
        double restVolume;      ///< m³, V₀
        double largestPressure; ///< Pa, of loads
        std::shared_ptr<const CavityWall> wall;
    };

    std::shared_ptr<const SpringNetwork> network;
    std::vector<double> mass; ///< kg per node
    std::vector<Element> springs;
    std::vector<HingeElement> hinges;
    std::vector<Tether> tethers;
    std::vector<char> fixed; ///< per node
    std::vector<Filled> cavities{};
};

/// N/m, where the spring is stiffest; tethers and hinges are linear.
inline double largestSpringConstant(const SpringSystem::Element& spring) {
    return largestSpringConstant(spring.springConstant, spring.secondPhase);
}
inline double largestSpringConstant(const Tether& tether) {
    return tether.springConstant;
}
inline double largestSpringConstant(const SpringSystem::HingeElement& hinge) {
    return hinge.springConstant;
}

/// Pa, that the fluid presses with at a volume, m³, by its own stiffness.
inline double ownPressure(const SpringSystem::Filled& cavity, double volume) {
    return cavity.stiffness * (1 - volume / cavity.restVolume);
}
/// Pa/m³, by which that falls as the volume grows.
inline double pressureSlope(const SpringSystem::Filled& cavity) {
    return cavity.stiffness / cavity.restVolume;
}

/// s, smallest d/c of all springs, tethers and hinges that can move: d ≥ ratio·k then holds for every motion,
/// since each gives its share of both; of a hinge that is bent at rest nearly. Infinite when nothing is
/// elastic.
double leastDampingRatio(const SpringSystem& system);

/// @throws InvalidModel with every problem of the model
SpringSystem makeSpringSystem(const TissueModel& model);

} // namespace esm
