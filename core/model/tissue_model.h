#pragma once

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
};

/// Biphasic springs: lengthened beyond a strain, each goes on with another spring constant, its force without
/// a jump [B 3.2, 4.1.2].
struct SpringStiffening {
    double strain = 0; ///< relative lengthening, > 0
    double factor = 1; ///< of the spring's own constant, > 0; below 1 it becomes softer

    bool operator==(const SpringStiffening&) const = default;
};
template<>
inline constexpr auto fieldsOf<SpringStiffening> = std::tuple{
    field("strain", &SpringStiffening::strain,
          positiveLimits("the strain beyond which springs go on with another spring constant", "",
                         largestNumber)),
    field("factor", &SpringStiffening::factor,
          positiveLimits("the factor of the spring constant of stretched springs", "", largestNumber))};

/// Everything a simulation needs to know of the tissue, evaluated: regions and scene are already in the
/// numbers.
struct TissueModel {
    std::shared_ptr<const SpringNetwork> network;
    std::vector<double> mass;                   ///< kg per node
    std::vector<double> springConstant;         ///< N/m per node; a spring takes its ends' mean
    std::vector<double> viscosity;              ///< N·s/m per node; a spring takes its ends' mean
    std::optional<SpringStiffening> stiffening; ///< of every spring, of no tether; linear without
    std::vector<Tether> tethers;
    std::vector<std::uint32_t> fixedNodes; ///< sorted, each once
};

/// Mean of the spring's two ends.
double springConstant(const TissueModel& model, const Spring& spring);
double viscosity(const TissueModel& model, const Spring& spring);

/// Every problem: sizes that do not agree, springs to missing nodes, parameters that are negative or beyond
/// 10³⁰ (a stretched spring's constant too), masses outside 10⁻³⁰ to 10³⁰ kg. Empty when the model can be
/// simulated.
std::vector<std::string> validate(const TissueModel& model);

} // namespace esm
