#include "core/project/region.h"

#include "core/project/wall.h"
#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

bool setsParameter(const std::string& output, Parameter parameter) {
    switch (parameter) {
    case Parameter::SpringConstant:
        return output == "spring_const" || output == "spring_constant" || output == "youngs_modulus";
    case Parameter::Viscosity:
        return output == "viscosity" || output == "relaxation_time";
    default:
        return output == "mass";
    }
}

void warnOfInputsOutOfRange(RegionTissue& tissue, const FuzzySystem& system,
                            const std::vector<std::optional<double>>& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const FuzzyVariable& variable = system.inputs[i];
        if (!inputs[i] || (*inputs[i] >= variable.minimum && *inputs[i] <= variable.maximum)) continue;
        tissue.warnings.push_back(variable.name + " " + roundedText(*inputs[i]) + " is out of its range, " +
                                  roundedText(variable.minimum) + " to " + roundedText(variable.maximum));
    }
}

/// Outputs without a value, unless one is held in its place.
void noteOutputsNotReached(RegionTissue& tissue, const Region& region) {
    for (std::size_t i = 0; i < region.system->outputs.size(); ++i) {
        const std::string& name = region.system->outputs[i].name;
        const bool isHeld =
            std::any_of(everyParameter.begin(), everyParameter.end(), [&](Parameter parameter) {
                return setsParameter(name, parameter) && valueOf(region.held, parameter);
            });
        if (!tissue.inference.outputs[i] && !isHeld) tissue.unreached.push_back(i);
    }
}

/// Outputs that set nothing because an earlier one sets the same, or because none has a parameter's name.
void warnOfUselessOutputs(RegionTissue& tissue, const FuzzySystem& system) {
    bool setsAny = false;
    for (const Parameter parameter : everyParameter) {
        const std::optional<std::size_t> first = outputFor(system, parameter);
        if (!first) continue;
        setsAny = true;
        for (std::size_t i = *first + 1; i < system.outputs.size(); ++i)
            if (setsParameter(system.outputs[i].name, parameter))
                tissue.warnings.push_back(system.outputs[i].name + " sets nothing, since " +
                                          system.outputs[*first].name + " before it sets the same");
    }
    if (!setsAny)
        tissue.warnings.push_back("the fuzzy system " + system.name +
                                  " sets no tissue: none of its outputs is named spring_constant, "
                                  "youngs_modulus, viscosity, relaxation_time or mass");
}

/// In the terms that the output speaks in.
void takeOutput(RegionTissue& tissue, const FuzzyVariable& output, Parameter parameter, double inferred,
                double wallThickness) {
    if (isRelaxationTime(output))
        tissue.relaxationTime = inferred;
    else
        valueOf(tissue.values, parameter) =
            isYoungsModulus(output) ? springConstantOfWall(inferred, wallThickness) : inferred;
}

/// Runs the system; what it says of tissue goes into `tissue`.
void takeInferred(RegionTissue& tissue, const Region& region, double wallThickness) {
    const FuzzySystem& system = *region.system;
    const auto inputs = orderedInputs(system, region.inputs);
    warnOfInputsOutOfRange(tissue, system, inputs);
    tissue.inference = infer(system, inputs);
    noteOutputsNotReached(tissue, region);
    warnOfUselessOutputs(tissue, system);
    for (const Parameter parameter : everyParameter)
        if (const auto output = outputFor(system, parameter))
            if (const auto inferred = tissue.inference.outputs[*output])
                takeOutput(tissue, system.outputs[*output], parameter, *inferred, wallThickness);
}

/// Takes a value no tissue can have out again, so that what lies beneath shows through. Rules may come to
/// anything: a system whose output reaches below zero is an author's slip that must not stop all the rest
/// from being simulated.
void dropImpossible(RegionTissue& tissue, Parameter parameter, const char* name) {
    const bool isOfMass = parameter == Parameter::Mass;
    std::optional<double>& value = valueOf(tissue.values, parameter);
    if (!value || (isOfMass ? isMass(*value) : isAmount(*value))) return;
    tissue.warnings.push_back(name + (" " + roundedText(*value)) +
                              (isOfMass ? " is not above zero" : " is not zero or more") + " and at most " +
                              roundedText(largestNumber) + ", so it stays as it was");
    value.reset();
}

/// A viscosity, where the region knows its spring constant.
void takeRelaxationTime(RegionTissue& tissue) {
    if (!isAmount(*tissue.relaxationTime)) {
        tissue.warnings.push_back("relaxation time " + roundedText(*tissue.relaxationTime) +
                                  " is not zero or more and at most " + roundedText(largestNumber) +
                                  ", so the viscosity stays as it was");
    } else if (tissue.values.springConstant) {
        tissue.values.viscosity = *tissue.relaxationTime * *tissue.values.springConstant;
    } else {
        return;
    }
    tissue.relaxationTime.reset();
}

} // namespace

std::optional<double>& valueOf(TissueValues& values, Parameter parameter) {
    if (parameter == Parameter::SpringConstant) return values.springConstant;
    return parameter == Parameter::Viscosity ? values.viscosity : values.mass;
}

std::optional<double> valueOf(const TissueValues& values, Parameter parameter) {
    TissueValues copy = values;
    return valueOf(copy, parameter);
}

std::optional<std::size_t> outputFor(const FuzzySystem& system, Parameter parameter) {
    for (std::size_t i = 0; i < system.outputs.size(); ++i)
        if (setsParameter(system.outputs[i].name, parameter)) return i;
    return std::nullopt;
}

std::optional<Parameter> parameterOf(const FuzzySystem& system, std::size_t output) {
    for (const Parameter parameter : everyParameter)
        if (outputFor(system, parameter) == output) return parameter;
    return std::nullopt;
}

bool isInClinicalUnits(const FuzzySystem& system, std::size_t output) {
    const FuzzyVariable& variable = system.outputs[output];
    return parameterOf(system, output) && (isYoungsModulus(variable) || isRelaxationTime(variable));
}

std::optional<double> valueOf(const NamedValues& values, const std::string& name) {
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const auto& value) { return value.first == name; });
    return found != values.end() ? std::optional(found->second) : std::nullopt;
}

void setInput(Region& region, const std::string& variable, double value) {
    const auto found = std::find_if(region.inputs.begin(), region.inputs.end(),
                                    [&](const auto& input) { return input.first == variable; });
    if (found != region.inputs.end())
        found->second = value;
    else
        region.inputs.emplace_back(variable, value);
}

// Smoothstep, Hermite's cubic with no slope at either end: parameters have no kink where the rim begins or
// ends. A straight line would have one at both.
double weightAt(const Region& region, const Eigen::Vector3d& point) {
    if (!region.ellipsoid) return 1;
    const Ellipsoid& ellipsoid = *region.ellipsoid;
    // Most of an organ is far away, which is quickly told; what is near the end is told exactly.
    const double reach = 1.001 * (ellipsoid.radii.maxCoeff() + region.rim);
    if ((point - ellipsoid.centre).squaredNorm() > reach * reach) return 0;
    if (contains(ellipsoid, point)) return 1;
    const double share = region.rim > 0 ? distanceOutside(ellipsoid, point) / region.rim : 1;
    return share < 1 ? (1 - share) * (1 - share) * (1 + 2 * share) : 0;
}

std::optional<double> inTermsOf(const FuzzyVariable& output, Parameter parameter, const TissueValues& tissue,
                                double wallThickness) {
    const auto value = valueOf(tissue, parameter);
    if (!value) return std::nullopt;
    if (isYoungsModulus(output)) return youngsModulusOf(tissue, wallThickness);
    if (!isRelaxationTime(output)) return value;
    return relaxationTimeOf(tissue);
}

std::optional<double> youngsModulusOf(const TissueValues& values, double wallThickness) {
    if (!values.springConstant) return std::nullopt;
    return youngsModulusOfWall(*values.springConstant, wallThickness);
}

std::optional<double> relaxationTimeOf(const TissueValues& values) {
    const auto& [springConstant, viscosity, mass] = values;
    const bool isKnown = springConstant && viscosity && *springConstant > 0;
    return isKnown ? std::optional(*viscosity / *springConstant) : std::nullopt;
}

std::optional<double> relaxationTimeOf(const RegionTissue& tissue) {
    return tissue.relaxationTime ? tissue.relaxationTime : relaxationTimeOf(tissue.values);
}

RegionTissue evaluate(const Region& region, double wallThickness) {
    RegionTissue tissue;
    if (region.system) takeInferred(tissue, region, wallThickness);
    for (const Parameter parameter : everyParameter)
        if (const auto held = valueOf(region.held, parameter)) valueOf(tissue.values, parameter) = held;
    if (region.held.viscosity) tissue.relaxationTime.reset();
    dropImpossible(tissue, Parameter::SpringConstant, "spring constant");
    if (tissue.relaxationTime) takeRelaxationTime(tissue);
    dropImpossible(tissue, Parameter::Viscosity, "viscosity");
    dropImpossible(tissue, Parameter::Mass, "mass");
    return tissue;
}

} // namespace esm
