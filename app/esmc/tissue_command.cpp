#include "app/esmc/arguments.h"
#include "app/esmc/commands.h"
#include "app/esmc/model_report.h"
#include "core/exchange/fuzzy_file.h"
#include "core/exchange/project_file.h"

#include <algorithm>

namespace esm {

namespace {

struct TissueOptions {
    std::string project, output, system, ellipsoid, name;
    std::vector<std::string> values, overrides;
    std::vector<double> biphasic; ///< strain and factor; empty without the option
    bool linear = false;
};

void declareTissue(CLI::App& command, TissueOptions& options) {
    command.add_option("project", options.project, "Project to read (.esm)")->required();
    command.add_option("-o,--output", options.output, "Project to write; may be the one that is read")
        ->required()
        ->check(writtenAs(".esm"));
    command.add_option("--system", options.system, "Fuzzy system: a JSON file, or a preset's name");
    command
        .add_option(
            "--set", options.values,
            "NAME=VALUE of an input of the system, a number or a term's name; repeat it for every input")
        ->allow_extra_args(false);
    command.add_option("--ellipsoid", options.ellipsoid,
                       "The region, \"cx cy cz rx ry rz [ax ay az degrees]\", m (default: the whole organ)");
    command.add_option("--name", options.name, "The region's name");
    command
        .add_option(
            "--override", options.overrides,
            "spring_constant=N/m, viscosity=N·s/m or mass=kg, in place of what is inferred; repeat it")
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
    command.add_flag("--linear", options.linear, "All springs of the organ are linear again")
        ->excludes(biphasic);
}

void hold(TissueValues& held, const std::string& name, double value) {
    if (value < 0 || (name == "mass" && value == 0))
        throw UsageError("--override " + name + ": the value must be " +
                         (name == "mass" ? "above zero" : "zero or more"));
    if (name == "spring_constant")
        held.springConstant = value;
    else if (name == "viscosity")
        held.viscosity = value;
    else if (name == "mass")
        held.mass = value;
    else
        throw UsageError("--override: '" + name + "' is not one of spring_constant, viscosity, mass");
}

/// Whether the command line speaks of all springs alone: then there is no region to add.
bool isOfSpringsAlone(const TissueOptions& options) {
    const bool hasLaw = options.linear || !options.biphasic.empty();
    return hasLaw && options.system.empty() && options.values.empty() && options.ellipsoid.empty() &&
           options.name.empty() && options.overrides.empty();
}

void setSpringLaw(BaseTissue& base, const TissueOptions& options) {
    if (options.linear) base.stiffening.reset();
    if (!options.biphasic.empty()) base.stiffening = {options.biphasic[0], options.biphasic[1]};
}

/// A colour that the regions before it do not have, as long as there are some left.
std::array<std::uint8_t, 3> colourOf(std::size_t region) {
    constexpr std::array<std::array<std::uint8_t, 3>, 6> colours{
        {{63, 182, 168}, {122, 162, 247}, {201, 138, 219}, {158, 194, 92}, {240, 136, 98}, {226, 112, 158}}};
    return colours.at(region % colours.size());
}

/// What the command line alone says of the region.
Region requestedRegion(const TissueOptions& options) {
    Region region;
    if (!options.ellipsoid.empty()) region.ellipsoid = parseEllipsoid(options.ellipsoid);
    if (!options.values.empty() && options.system.empty())
        throw UsageError("--set speaks of a fuzzy system's inputs; name the system with --system");
    for (const auto& [name, value] : parsePairs(options.overrides, "--override"))
        hold(region.held, name, value);
    return region;
}

void addValue(Report& report, const char* key, const std::string& label, const std::optional<double>& value) {
    report.json[key] = inJson(value);
    report.text.push_back(label + (value ? inText(*value) : "as it was"));
}

/// @param region its name; empty: the whole organ, to which none was added
Report describe(const std::optional<std::string>& region, const RegionResult& result) {
    const TissueValues& values = result.tissue.values;
    Report report;
    report.json["region"] = region ? Json(*region) : Json();
    report.json["nodes"] = result.nodes;
    report.json["springs"] = result.springs;
    report.text.push_back((region ? "region " + *region : "the whole organ") + ": " +
                          counted(result.nodes, "node") + ", " + counted(result.springs, "spring"));
    addValue(report, "spring_constant", "spring constant, N/m: ", values.springConstant);
    addValue(report, "viscosity", "viscosity, N·s/m: ", values.viscosity);
    addValue(report, "mass", "mass, kg: ", values.mass);
    addWarnings(report, result.tissue.warnings);
    return report;
}

/// Gives the region what only the project and files can tell.
void complete(Region& region, const TissueOptions& options, const NamedWords& inputs,
              const Project& project) {
    if (!options.system.empty()) {
        region.system = std::make_shared<const FuzzySystem>(findFuzzySystem(options.system).system);
        region.inputs = inputsFor(*region.system, inputs, "--set");
    }
    region.colour = colourOf(project.regions.size());
    region.name = !options.name.empty() ? options.name
                  : region.ellipsoid    ? "region " + std::to_string(project.regions.size() + 1)
                                        : "whole organ";
}

Report runTissue(const TissueOptions& options, Context& context) {
    Region region = requestedRegion(options);
    const NamedWords inputs = parseNamedWords(options.values, "--set");
    context.subject = options.project;
    Project project = loadProject(options.project);
    setSpringLaw(project.base, options);
    const bool addsRegion = !isOfSpringsAlone(options);
    if (addsRegion) complete(region, options, inputs, project);
    const RegionResult result = evaluateRegion(project, region);
    if (addsRegion) project.regions.push_back(region);
    saveProject(project, options.output);
    Report report = describe(addsRegion ? std::optional(region.name) : std::nullopt, result);
    addSpringLaw(report, project.base.stiffening);
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
