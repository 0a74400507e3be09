#include "app/esmc/arguments.h"
#include "app/esmc/bending_option.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "app/esmc/opened_file.h"
#include "app/esmc/project_output.h"
#include "core/authoring/regions.h"
#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/project/tissue_preset_file.h"
#include "core/project/surroundings.h"
#include "core/project/tissue_beneath.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

struct TissueOptions {
    std::string project, output, preset, system, ellipsoid, name;
    std::vector<std::string> values, overrides;
    double rim = 0;                      ///< m
    std::vector<double> biphasic;        ///< strain and factor; empty without the option
    std::optional<double> wallThickness; // m
    bool linear = false;
    BendingOption bending;
};

void declareTissue(CLI::App& command, TissueOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    auto* preset = command
                       .add_option("--preset", options.preset,
                                   "Tissue as it was published: a system and its inputs and, for the whole "
                                   "organ, mass and tethers")
                       ->check(oneOf(tissuePresetNames()))
                       ->option_text(joined(tissuePresetNames(), "|"));
    command
        .add_option("--system", options.system,
                    "Fuzzy system: a file (.json, .fcl, .fll), or a preset's name")
        ->excludes(preset);
    command
        .add_option(
            "--set", options.values,
            "NAME=VALUE of an input of the system, a number or a term's name; repeat it for every input")
        ->allow_extra_args(false)
        ->excludes(preset);
    command.add_option("--ellipsoid", options.ellipsoid,
                       "The region, \"cx cy cz rx ry rz [ax ay az degrees]\", m (default: the whole organ)");
    command
        .add_option("--rim", options.rim,
                    "Width of the region's soft rim, m: around the ellipsoid its tissue fades into what lies "
                    "beneath (default: 0, sharp)")
        ->type_name("M")
        ->check(numberWithin(0, largestNumber));
    command.add_option("--name", options.name, "The region's name");
    command
        .add_option(
            "--override", options.overrides,
            "spring_constant=N/m or youngs_modulus=Pa, viscosity=N·s/m or relaxation_time=s, mass=kg, in "
            "place of what is inferred; repeat it")
        ->allow_extra_args(false);
    auto* biphasic =
        command
            .add_option(
                "--biphasic", options.biphasic,
                "All springs of the organ go on FACTOR times as stiff once they are lengthened by more "
                "than STRAIN of their rest length (0.2: a fifth)")
            ->type_name("STRAIN FACTOR")
            ->expected(2)
            ->check(positiveNumber());
    command
        .add_option("--wall-thickness", options.wallThickness,
                    "Thickness of the organ's wall, m, of which spring constants mean Young's moduli (0.003 "
                    "until it is said)")
        ->check(numberWithin(1e-6, thickestWall));
    command.add_flag("--linear", options.linear, "All springs of the organ are linear again")
        ->excludes(biphasic);
    declareBending(command, options.bending);
    command.get_option("--bending")->excludes("--wall-thickness");
}

bool isInClinicalUnits(const std::string& override) {
    return override == "youngs_modulus" || override == "relaxation_time";
}

void hold(TissueValues& held, const std::string& name, double value) {
    const bool isOfMass = name == "mass";
    if (!(isOfMass ? isMass(value) : isAmount(value)))
        throw UsageError("--override " + name + ": the value must be from " +
                         (isOfMass ? roundedText(1 / largestNumber) : "0") + " to " +
                         roundedText(largestNumber));
    if (name == "spring_constant")
        held.springConstant = value;
    else if (name == "viscosity")
        held.viscosity = value;
    else if (isOfMass)
        held.mass = value;
    else if (!isInClinicalUnits(name))
        throw UsageError("--override: '" + name +
                         "' is not one of spring_constant, youngs_modulus, viscosity, relaxation_time, mass");
}

void requireOneOf(const NamedValues& pairs, const std::string& one, const std::string& other) {
    if (esm::valueOf(pairs, one) && esm::valueOf(pairs, other))
        throw UsageError("--override: " + one + " and " + other + " say the same; give one of them");
}

/// What only the organ's wall and the region's tissue make values of. @throws UsageError
void holdInClinicalUnits(Region& region, const std::vector<std::string>& overrides, double wallThickness) {
    const NamedValues pairs = parsePairs(overrides, "--override");
    requireOneOf(pairs, "youngs_modulus", "spring_constant");
    requireOneOf(pairs, "relaxation_time", "viscosity");
    if (const auto modulus = esm::valueOf(pairs, "youngs_modulus"))
        hold(region.held, "spring_constant", springConstantOfWall(*modulus, wallThickness));
    const auto time = esm::valueOf(pairs, "relaxation_time");
    if (!time) return;
    const auto springConstant = evaluate(region, wallThickness).values.springConstant;
    if (!springConstant)
        throw UsageError("--override relaxation_time: the region keeps the spring constant beneath; give "
                         "youngs_modulus or spring_constant as well");
    hold(region.held, "viscosity", *time * *springConstant);
}

using ChosenPreset = std::optional<TissuePreset>;

/// @throws UsageError where it does not go with the other options
ChosenPreset chosenPreset(const TissueOptions& options) {
    if (options.preset.empty()) return std::nullopt;
    TissuePreset preset = tissuePreset(options.preset);
    if (!preset.system && !options.ellipsoid.empty())
        throw UsageError("--preset " + preset.name + " ties the whole organ; leave out --ellipsoid");
    return preset;
}

/// Whether the command line speaks of all springs or of what ties the organ alone: then there is no region to
/// add.
bool isOfOrganAlone(const TissueOptions& options, const ChosenPreset& preset) {
    const bool hasLaw =
        options.linear || !options.biphasic.empty() || options.wallThickness || options.bending.isGiven;
    const bool hasWords = !options.system.empty() || (preset && preset->system);
    return (hasLaw || preset) && !hasWords && options.values.empty() && options.ellipsoid.empty() &&
           options.rim == 0 && options.name.empty() && options.overrides.empty();
}

void setSpringLaw(BaseTissue& base, const TissueOptions& options) {
    if (options.linear) base.stiffening.reset();
    if (options.wallThickness) base.wallThickness = *options.wallThickness;
    if (!options.biphasic.empty()) base.stiffening = {options.biphasic[0], options.biphasic[1]};
}

/// What the command line alone says of the region.
Region requestedRegion(const TissueOptions& options, const ChosenPreset& preset) {
    Region region;
    if (preset) layPreset(region, *preset);
    if (preset && options.ellipsoid.empty()) region.held.mass = preset->mass;
    if (!options.ellipsoid.empty()) region.ellipsoid = parseEllipsoid(options.ellipsoid);
    if (options.rim > 0 && !region.ellipsoid)
        throw UsageError("--rim: only an ellipsoid has a rim; give --ellipsoid as well");
    region.rim = options.rim;
    if (!options.values.empty() && options.system.empty())
        throw UsageError("--set speaks of a fuzzy system's inputs; name the system with --system");
    for (const auto& [name, value] : parsePairs(options.overrides, "--override"))
        hold(region.held, name, value);
    return region;
}

/// What is not set keeps what lies beneath.
void addValue(Report& report, const char* key, Parameter parameter, const RegionResult& result,
              const std::optional<TissueBeneath>& beneath) {
    static constexpr std::array<const char*, 3> labels{
        "spring constant, N/m: ", "viscosity, N·s/m: ", "mass, kg: "};
    const std::optional<double> value = valueOf(result.tissue.values, parameter);
    report.json[key] = inJson(value);
    const std::string kept = beneath ? "as it was, " + inWords(*beneath, parameter) : "as it was";
    const bool isByTime = parameter == Parameter::Viscosity && result.tissue.relaxationTime;
    const std::string text = value ? inText(*value) : isByTime ? "by the relaxation time" : kept;
    report.text.push_back(labels[static_cast<std::size_t>(parameter)] + text);
}

void addClinicalUnits(Report& report, const RegionTissue& tissue, double wallThickness) {
    const auto modulus = youngsModulusOf(tissue.values, wallThickness), time = relaxationTimeOf(tissue);
    report.json["youngs_modulus"] = inJson(modulus);
    report.json["relaxation_time"] = inJson(time);
    if (modulus)
        report.text.push_back("Young's modulus of a wall of " + inText(1000 * wallThickness) +
                              " mm, kPa: " + inText(*modulus / 1000));
    if (time)
        report.text.push_back("relaxation time, s: " + inText(*time) +
                              (tissue.relaxationTime ? ", times the spring constant beneath" : ""));
}

/// @param region its name; empty: the whole organ, to which none was added
Report describe(const std::optional<std::string>& region, bool hasRim, const RegionResult& result,
                const std::optional<TissueBeneath>& beneath, double wallThickness) {
    Report report;
    report.json["region"] = region ? Json(*region) : Json();
    report.json["nodes"] = result.nodes;
    report.json["springs"] = result.springs;
    report.json["rim_nodes"] = result.rimNodes;
    report.json["rim_springs"] = result.rimSprings;
    report.text.push_back((region ? "region " + *region : "the whole organ") + ": " +
                          counted(result.nodes, "node") + ", " + counted(result.springs, "spring"));
    if (hasRim)
        report.text.push_back("in its soft rim: " + counted(result.rimNodes, "node") + ", " +
                              counted(result.rimSprings, "spring"));
    addValue(report, "spring_constant", Parameter::SpringConstant, result, beneath);
    addValue(report, "viscosity", Parameter::Viscosity, result, beneath);
    addValue(report, "mass", Parameter::Mass, result, beneath);
    addClinicalUnits(report, result.tissue, wallThickness);
    addWarnings(report, result.tissue.warnings);
    return report;
}

void addPreset(Report& report, const ChosenPreset& preset, std::size_t tethers) {
    report.json["preset"] = preset ? Json(preset->name) : Json();
    report.json["tethers"] = tethers;
    if (!preset) return;
    report.text.push_back(counted(tethers, "tether") + " on the whole organ");
    report.text.push_back((isMeasured(*preset) ? "measured: " : "published: ") + publishedText(*preset) +
                          " (" + preset->source + ")");
}

/// Gives the region what only the project and files can tell. Adds to `warnings` what of the fuzzy system's
/// file could not be taken.
void complete(Region& region, const TissueOptions& options, const NamedWords& inputs, const Project& project,
              std::vector<std::string>& warnings) {
    if (!options.system.empty()) {
        ImportedFuzzySystem imported = findFuzzySystem(options.system);
        region.system = std::make_shared<const FuzzySystem>(std::move(imported.system));
        warnings.insert(warnings.end(), imported.warnings.begin(), imported.warnings.end());
        region.inputs = inputsFor(*region.system, inputs, "--set");
    }
    region.colour = unusedColour(project.regions);
    region.name = !options.name.empty() ? options.name
                  : region.ellipsoid    ? "region " + std::to_string(project.regions.size() + 1)
                                        : "whole organ";
}

/// What of a preset is of a whole organ and does not come with a part of one.
std::vector<std::string> presetWarnings(const ChosenPreset& preset, const Region& region) {
    std::vector<std::string> left;
    if (preset && region.ellipsoid && preset->mass)
        left.push_back("its mass, " + roundedText(*preset->mass) + " kg,");
    if (preset && region.ellipsoid && !preset->tethers.empty()) left.emplace_back("its tethers");
    if (left.empty()) return {};
    return {"--preset " + preset->name + ": " + joined(left, " and ") + (left.size() > 1 ? " are" : " is") +
            " of the whole organ and left out of this region"};
}

Report runTissue(const TissueOptions& options, Context& context) {
    const ChosenPreset preset = chosenPreset(options);
    Region region = requestedRegion(options, preset);
    const NamedWords inputs = parseNamedWords(options.values, "--set");
    context.subject = options.project;
    const ProjectOutput output(options.output);
    Project project = openedProject(options.project, context);
    setSpringLaw(project.base, options);
    setBending(project, options.bending);
    if (preset && !region.ellipsoid) tiePreset(project.scene, *preset);
    const bool addsRegion = !isOfOrganAlone(options, preset);
    std::vector<std::string> warnings = presetWarnings(preset, region);
    if (addsRegion) complete(region, options, inputs, project, warnings);
    holdInClinicalUnits(region, options.overrides, project.base.wallThickness);
    RegionResult result = evaluateRegion(project, region);
    std::vector<std::string>& tissueWarnings = result.tissue.warnings;
    tissueWarnings.insert(tissueWarnings.begin(), warnings.begin(), warnings.end());
    const auto beneath = tissueBeneath(project, region);
    if (addsRegion) project.regions.push_back(region);
    output.save(project);
    Report report = describe(addsRegion ? std::optional(region.name) : std::nullopt, region.rim > 0, result,
                             beneath, project.base.wallThickness);
    addPreset(report, preset, tetherCountOf(*project.network, project.scene));
    addSpringLaw(report, project.base.stiffening);
    addBending(report, project.base, *project.network);
    addWritten(report, options.output);
    return report;
}

} // namespace

void addTissueCommand(CLI::App& app, Context& context) {
    addCommand(app, context,
               Command<TissueOptions>{"tissue", "Say how the tissue of a region, or all springs, behave",
                                      declareTissue, runTissue});
}

} // namespace esm
