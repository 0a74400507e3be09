#include "core/exchange/model_package.h"
#include "core/exchange/package/glb.h"
#include "core/exchange/package/package_checksums.h"
#include "core/exchange/package/package_container.h"
#include "core/exchange/package/package_drawn.h"
#include "core/exchange/package/package_layout.h"
#include "core/exchange/package/tissue_reader.h"
#include "core/exchange/project/model_json.h"
#include "core/exchange/project/region_json.h"
#include "core/project/project_warnings.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"

#include <algorithm>
#include <fstream>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

/// A reader of the version that the file says it is would take stiffer springs for linear, or infer
/// otherwise.
void checkVersion(const JsonReader& extension, const ModelPackage& package) {
    const bool isBound = extension.has("binding");
    VersionNeeds needs = needsOf(package.regions, package.base, isBound);
    const bool isClinical = std::exchange(needs.clinicalUnits, false);
    const bool resistsBending = std::exchange(needs.bending, false);
    int version = versionOf(needs);
    if (isBound && extension.member("binding").has("starts"))
        version = std::max(version, package_layout::versionOfWideBindings);
    if (extension.has("texture") && extension.member("texture").has("layout"))
        version = std::max(version, package_layout::versionOfStretchedLayouts);
    if (const auto& lattice = package.tissue.network->lattice)
        version = package_layout::versionOfFilled(lattice->filling.kind);
    if (isClinical) version = package_layout::versionOfClinicalUnits;
    if (extension.has("fillings")) version = package_layout::versionOfFillings;
    if (extension.has("hinges") || resistsBending) version = package_layout::versionOfHinges;
    const auto needed = static_cast<std::uint64_t>(version);
    if (extension.member("version").integer(1, modelPackageVersion) < needed)
        extension.member("version").addProblem("should be " + std::to_string(needed) + " for what it holds");
}

void checkStiffening(const JsonReader& extension, const ModelPackage& package) {
    if (!(package.tissue.stiffening == package.base.stiffening))
        extension.member("base").addProblem("should have the same stiffening as the package");
}

ModelPackage readContent(const Bytes& file, const Glb& glb, std::vector<std::string>& problems) {
    const JsonReader gltf(glb.json, "", problems), extension = springMassOf(gltf);
    const std::vector<std::size_t> damaged = damagedViews(file, glb, problems);
    if (!problems.empty()) return {};
    checkNamesOfExtension(gltf);
    const GltfArrayReader arrays(glb, problems, damaged);
    ModelPackage package{readTissue(extension, arrays)};
    package.base = valueFrom<BaseTissue>(extension.member("base"));
    checkStiffening(extension, package);
    package.regions = regionsFromJson(extension.member("fuzzySystems"), extension.member("regions")).regions;
    checkVersion(extension, package);
    readValue(extension.member("baseColour"), package.baseColour, PlainForms());
    if (problems.empty()) readDrawn(extension, arrays, problems, package);
    if (problems.empty()) problems = damageProblems(glb, damaged);
    return package;
}

/// The parts that a project has too.
Project projectOf(const ModelPackage& package) {
    Project project;
    project.name = package.name;
    project.mesh = std::make_shared<TriangleMesh>(package.mesh);
    project.importReport = std::make_shared<RepairReport>();
    project.network = package.tissue.network;
    project.base = package.base;
    project.regions = package.regions;
    project.stepping = package.stepping;
    project.atlas = package.atlas;
    return project;
}

/// Problems of the parts that a project has too, and of the tissue.
std::vector<std::string> problemsOf(const ModelPackage& package, const Project& project) {
    std::vector<std::string> problems = validate(project);
    for (std::string& problem : validate(package.tissue))
        if (std::find(problems.begin(), problems.end(), problem) == problems.end())
            problems.push_back(std::move(problem));
    for (std::string& problem : descriptionProblems(package))
        problems.push_back(std::move(problem));
    return problems;
}

struct ReadPackage {
    ModelPackage package; ///< of use only without problems
    std::vector<std::string> problems, warnings;
};

ReadPackage readPackage(const std::filesystem::path& file) {
    const Bytes content = readFile(file);
    std::vector<std::string> problems;
    try {
        const Glb glb = parseGlb(content);
        ModelPackage package = readContent(content, glb, problems);
        const Project project = projectOf(package);
        if (problems.empty()) problems = problemsOf(package, project);
        std::vector<std::string> warnings = containerWarnings(glb);
        if (!problems.empty()) return {{}, eachOnce(problems), warnings};
        const Json& extension = glb.json["extensions"][package_layout::extension];
        for (std::string& warning : steppingWarnings(extension))
            warnings.push_back(std::move(warning));
        for (std::string& warning : projectWarnings(project))
            warnings.push_back(std::move(warning));
        return {std::move(package), {}, std::move(warnings)};
    } catch (const InvalidModel& error) {
        return {{}, error.problems(), {}};
    }
}

} // namespace

bool isModelPackage(const std::filesystem::path& file) {
    std::error_code error;
    std::string start(4, '\0');
    if (std::filesystem::is_regular_file(file, error))
        std::ifstream(file, std::ios::binary).read(start.data(), 4);
    if (start == "glTF") return true;
    return start != std::string("PK\3\4", 4) && file.extension() == ".glb";
}

OpenedPackage openPackage(const std::filesystem::path& file) {
    ReadPackage read = readPackage(file);
    if (!read.problems.empty()) throw FileError(file, InvalidModel(read.problems).what());
    return {std::move(read.package), std::move(read.warnings)};
}

ModelPackage loadPackage(const std::filesystem::path& file) {
    return openPackage(file).package;
}

std::vector<std::string> validatePackage(const std::filesystem::path& file) {
    ReadPackage read = readPackage(file);
    read.problems.insert(read.problems.end(), read.warnings.begin(), read.warnings.end());
    return read.problems;
}

} // namespace esm
