#include "core/project/tissue_beneath.h"

#include "core/support/numbers.h"

#include <algorithm>

namespace esm {

namespace {

void include(ValueSpan& span, double value) {
    span.least = std::min(span.least, value);
    span.most = std::max(span.most, value);
}

TissueModel modelBeneath(const Project& project, const Region& region) {
    Project beneath = project;
    if (const auto place = placeOf(project.regions, region.id)) beneath.regions.resize(*place);
    return evaluateModel(beneath, Scene());
}

} // namespace

std::string inWords(const ValueSpan& span, const std::string& unit) {
    const std::string least = roundedText(span.least, 4), most = roundedText(span.most, 4);
    return (least == most ? least : least + " to " + most) + " " + unit;
}

std::optional<TissueBeneath> tissueBeneath(const Project& project, const Region& region) {
    const TissueModel model = modelBeneath(project, region);
    const std::vector<double> weights = nodeWeights(*model.network, region);
    std::optional<TissueBeneath> beneath;
    for (std::size_t node = 0; node < weights.size(); ++node) {
        if (weights[node] == 0) continue;
        const double constant = model.springConstant[node], viscosity = model.viscosity[node];
        if (!beneath) beneath = TissueBeneath{{constant, constant}, {viscosity, viscosity}, 0};
        include(beneath->springConstant, constant);
        include(beneath->viscosity, viscosity);
        beneath->mass += weights[node] * model.mass[node];
    }
    return beneath;
}

std::string inWords(const TissueBeneath& beneath, Parameter parameter) {
    if (parameter == Parameter::SpringConstant) return inWords(beneath.springConstant, "N/m");
    if (parameter == Parameter::Viscosity) return inWords(beneath.viscosity, "N·s/m");
    return inWords(ValueSpan{beneath.mass, beneath.mass}, "kg");
}

} // namespace esm
