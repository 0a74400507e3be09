#pragma once

#include "core/model/cavity.h"
#include "core/model/hinge.h"
#include "core/model/scene.h"
#include "core/model/spring_network.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// A spring from a node to its own rest position.
struct Tether {
    std::uint32_t node;
    double springConstant; ///< N/m
    double viscosity;      ///< N·s/m

    bool operator==(const Tether&) const = default;
};

/// Biphasic springs: lengthened beyond a strain, each goes on with another spring constant, its force without
/// a jump [B 3.2, 4.1.2].
struct SpringStiffening {
    double strain = 0; ///< relative lengthening, > 0
    double factor = 1; ///< of the spring's own constant, > 0; below 1 it becomes softer

    bool operator==(const SpringStiffening&) const = default;
};
template<>
inline constexpr auto fieldsOf<SpringStiffening> = fieldTable(
    field("strain", &SpringStiffening::strain,
          positiveLimits("the strain beyond which springs go on with another spring constant", "",
                         largestNumber)),
    field("factor", &SpringStiffening::factor,
          positiveLimits("the factor of the spring constant of stretched springs", "", largestNumber)));

/// What one spring is made of, where that is not the mean of its ends.
struct SpringValues {
    double springConstant; ///< N/m
    double viscosity;      ///< N·s/m

    bool operator==(const SpringValues&) const = default;
};

/// Everything a simulation needs to know of the tissue, evaluated: regions and scene are already in the
/// numbers.
struct TissueModel {
    std::shared_ptr<const SpringNetwork> network;
    std::vector<double> mass;            ///< kg per node
    std::vector<double> springConstant;  ///< N/m per node, as regions say; a spring takes its ends' mean
    std::vector<double> viscosity;       ///< N·s/m per node, as regions say; the same
    std::vector<SpringValues> ownValues; ///< one per spring, in place of the means; empty: none has its own
    std::optional<SpringStiffening> stiffening; ///< of every spring, of no tether; linear without
    std::vector<Hinge> hinges;                  ///< that resist bending; linear; none: only springs resist
    std::vector<Tether> tethers;
    std::vector<std::uint32_t> fixedNodes; ///< sorted, each once
    std::vector<Cavity> cavities{};        ///< of other parts each; those that a load may press from within
};

/// Of the network's spring of that number: its own, or the mean of its two ends.
SpringValues valuesOf(const TissueModel& model, std::size_t spring);
/// The same of all springs.
std::vector<SpringValues> springValues(const TissueModel& model);

/// Relative to the larger of a spring's ends, how far its values may be from their mean and still be taken
/// for it: what 32-bit numbers of packages are rounded by, with room to spare.
constexpr double meanTolerance = 1e-6;
/// Whether a value of a spring is the mean of its ends'.
bool isMean(double value, double first, double second);
/// Whether some spring is not its ends' mean.
bool hasOwnValues(const TissueModel& model);

/// Every problem: sizes that do not agree, springs to missing nodes, parameters that are negative or beyond
/// 10³⁰ (a stretched spring's constant too), masses outside 10⁻³⁰ to 10³⁰ kg. Empty when the model can be
/// simulated.
std::vector<std::string> validate(const TissueModel& model);

} // namespace esm
