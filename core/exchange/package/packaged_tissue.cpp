#include "core/exchange/package/packaged_tissue.h"

#include "core/exchange/package/package_checksums.h"
#include "core/exchange/package/tissue_reader.h"
#include "core/support/errors.h"
#include "core/support/offenders.h"

namespace esm {

PackagedTissue loadPackagedTissue(const std::filesystem::path& file) {
    const Bytes content = readFile(file);
    std::vector<std::string> problems;
    PackagedTissue package;
    try {
        const Glb glb = parseGlb(content);
        const JsonReader extension = springMassOf(JsonReader(glb.json, "", problems));
        const std::vector<std::size_t> damaged = damagedViews(content, glb, problems);
        if (problems.empty()) package = readTissue(extension, GltfArrayReader(glb, problems, damaged));
        if (problems.empty()) problems = damageProblems(glb, damaged);
        if (problems.empty()) problems = validate(package);
    } catch (const InvalidModel& error) {
        problems = error.problems();
    }
    if (!problems.empty()) throw FileError(file, InvalidModel(eachOnce(problems)).what());
    return package;
}

std::vector<std::string> descriptionProblems(const PackagedTissue& package) {
    std::vector<std::string> problems;
    if (package.material)
        addUnder(problems, "material", validate(*package.material, package.tissue.mass.size()));
    if (package.provenance) addUnder(problems, "provenance", validate(*package.provenance));
    return problems;
}

std::vector<std::string> validate(const PackagedTissue& package) {
    std::vector<std::string> problems = validate(package.mesh);
    for (const auto& found : {carryingProblems(package.mesh, *package.tissue.network),
                              validate(package.tissue), descriptionProblems(package)})
        problems.insert(problems.end(), found.begin(), found.end());
    if (package.stepping) addUnder(problems, "stepping", validate(*package.stepping));
    return problems;
}

} // namespace esm
