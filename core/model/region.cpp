#include "core/model/region.h"

#include <cmath>
#include <sstream>

namespace esm {

namespace {

std::string inWarning(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

bool sets(const std::string& output, const char* parameter) {
    return output == parameter || (output == "spring_const" && std::string(parameter) == "spring_constant");
}

void warnOfInputsOutOfRange(RegionTissue& tissue, const FuzzySystem& system,
                            const std::vector<std::optional<double>>& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const FuzzyVariable& variable = system.inputs[i];
        if (!inputs[i] || (*inputs[i] >= variable.minimum && *inputs[i] <= variable.maximum)) continue;
        tissue.warnings.push_back(variable.name + " " + inWarning(*inputs[i]) + " is out of its range, " +
                                  inWarning(variable.minimum) + " to " + inWarning(variable.maximum));
    }
}

/// Runs the system; what it says of tissue goes into `tissue.values`.
void takeInferred(RegionTissue& tissue, const Region& region) {
    const FuzzySystem& system = *region.system;
    const auto inputs = orderedInputs(system, region.inputs);
    warnOfInputsOutOfRange(tissue, system, inputs);
    tissue.inference = infer(system, inputs);
    for (std::size_t i = 0; i < system.outputs.size(); ++i) {
        const std::string& name = system.outputs[i].name;
        const std::optional<double>& value = tissue.inference.outputs[i];
        if (!value)
            tissue.warnings.push_back("no rule reaches " + name + ", which stays as it was");
        else if (sets(name, "spring_constant"))
            tissue.values.springConstant = value;
        else if (sets(name, "viscosity"))
            tissue.values.viscosity = value;
        else if (sets(name, "mass"))
            tissue.values.mass = value;
    }
}

/// Takes a value no tissue can have out again, so that what lies beneath shows through.
void dropImpossible(RegionTissue& tissue, std::optional<double>& value, const char* name, bool zeroAllowed) {
    if (!value || (std::isfinite(*value) && (*value > 0 || (zeroAllowed && *value == 0)))) return;
    tissue.warnings.push_back(std::string(name) + " " + inWarning(*value) +
                              (zeroAllowed ? " is below zero" : " is not above zero") +
                              ", so it stays as it was");
    value.reset();
}

} // namespace

RegionTissue evaluate(const Region& region) {
    RegionTissue tissue;
    if (region.system) takeInferred(tissue, region);
    TissueValues& values = tissue.values;
    if (region.held.springConstant) values.springConstant = region.held.springConstant;
    if (region.held.viscosity) values.viscosity = region.held.viscosity;
    if (region.held.mass) values.mass = region.held.mass;
    dropImpossible(tissue, values.springConstant, "spring constant", true);
    dropImpossible(tissue, values.viscosity, "viscosity", true);
    dropImpossible(tissue, values.mass, "mass", false);
    return tissue;
}

} // namespace esm
