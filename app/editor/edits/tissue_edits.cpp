#include "app/editor/edits/tissue_edits.h"

#include "app/editor/edits/input_edits.h"
#include "app/editor/edits/parameter_name.h"
#include "core/authoring/regions.h"
#include "core/fuzzy/inverse.h"

namespace esm {

namespace {

void setHeld(Document& document, RegionId region, Parameter parameter, std::optional<double> value,
             EditKind kind) {
    const QString name = parameterName(parameter, Extent::Region);
    document.edit((value ? QObject::tr("Hold %1") : QObject::tr("Let go of %1")).arg(name),
                  [&](Project& project) { valueOf(partOf(project.regions, region).held, parameter) = value; },
                  {kind, region, static_cast<std::uint64_t>(parameter)});
}

/// @param wanted in the terms of the output that sets the parameter
/// @param value of the parameter
void setInWordsOrByHand(Document& document, std::optional<RegionId> region, Parameter parameter,
                        double wanted, double value) {
    if (!region) return setParameter(document, region, parameter, value);
    const Region& tissue = partOf(document.project().regions, *region);
    const auto output = tissue.system ? outputFor(*tissue.system, parameter) : std::nullopt;
    const bool isSaid =
        output && isInClinicalUnits(*tissue.system, *output) && !valueOf(tissue.held, parameter);
    const auto reached =
        isSaid ? reachingInput(*tissue.system, orderedInputs(*tissue.system, tissue.inputs), *output, wanted)
               : std::nullopt;
    if (!reached) return setParameter(document, region, parameter, value);
    editInputs(document, *region, {{tissue.system->inputs[reached->input].name, reached->value}});
}

} // namespace

void setParameter(Document& document, std::optional<RegionId> region, Parameter parameter, double value) {
    if (region) return setHeld(document, *region, parameter, value, EditKind::HeldValue);
    document.edit(
        QObject::tr("Set %1").arg(parameterName(parameter, Extent::Base)),
        [&](Project& project) { valueOf(project.base, parameter) = value; },
        MergeKey(EditKind::BaseTissue, static_cast<std::uint64_t>(parameter)));
}

void setYoungsModulus(Document& document, std::optional<RegionId> region, double youngsModulus) {
    const double thickness = document.project().base.wallThickness;
    setInWordsOrByHand(document, region, Parameter::SpringConstant, youngsModulus,
                       springConstantOfWall(youngsModulus, thickness));
}

void setRelaxationTime(Document& document, std::optional<RegionId> region, double relaxationTime) {
    const Project& project = document.project();
    const auto springConstant =
        region ? evaluate(partOf(project.regions, *region), project.base.wallThickness).values.springConstant
               : std::optional(project.base.springConstant);
    if (!springConstant) return;
    setInWordsOrByHand(document, region, Parameter::Viscosity, relaxationTime,
                       relaxationTime * *springConstant);
}

void holdParameter(Document& document, std::optional<RegionId> region, Parameter parameter, double value) {
    if (region) setHeld(document, *region, parameter, value, EditKind::Alone);
}

void letParameterGo(Document& document, std::optional<RegionId> region, Parameter parameter) {
    if (region) setHeld(document, *region, parameter, std::nullopt, EditKind::Alone);
}

} // namespace esm
