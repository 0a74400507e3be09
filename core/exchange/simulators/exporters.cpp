#include "core/exchange/simulators/exporters.h"

#include "core/exchange/model_package.h"
#include "core/exchange/simulators/inventor_file.h"
#include "core/exchange/simulators/mujoco/mujoco_folder.h"
#include "core/exchange/simulators/obj_folder.h"
#include "core/exchange/simulators/sofa/sofa_folder.h"
#include "core/exchange/simulators/vtk_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/letters.h"
#include "core/support/new_folder.h"

#include <algorithm>

namespace esm {

const std::vector<Exporter>& exporters() {
    static const std::vector<Exporter> all{
        {"glb", ".glb", "Model packages", "the model package for simulators, a textured mesh to any viewer",
         writePackage, true, true},
        {.name = "vtp",
         .ending = ".vtp",
         .title = "VTK surfaces",
         .purpose = "surface and springs with their parameters as arrays, for ParaView and 3D Slicer",
         .write = writeVtp,
         .differences = vtpDifferences},
        {.name = "vtu",
         .ending = ".vtu",
         .title = "VTK grids",
         .purpose = "the same with the tetrahedra of a filled organ, for ParaView and 3D Slicer",
         .write = writeVtu,
         .differences = vtuDifferences},
        {.name = "sofa",
         .ending = ".sofa",
         .title = "Scenes for SOFA",
         .purpose = "a folder with a scene, springs, surface and texture, which SOFA loads",
         .write = writeSofa,
         .holdsPictures = true,
         .isFolder = true,
         .isStepped = true,
         .hasReleases = true,
         .canBeTried = true,
         .differences = sofaDifferences},
        {.name = "iv",
         .ending = ".iv",
         .title = "Open Inventor files",
         .purpose =
             "textured surface and the spring-mass model in a node of its own, for Open Inventor and Coin",
         .write = writeInventor,
         .differences = inventorDifferences,
         .otherName = "inventor"},
        {.name = "obj",
         .ending = ".tables",
         .title = "OBJ and tables",
         .purpose = "a folder with the surface as OBJ and all else as CSV, for spreadsheets and scripts",
         .write = writeObjFolder,
         .holdsPictures = true,
         .isFolder = true,
         .differences = objFolderDifferences},
        {.name = "mjcf",
         .ending = ".mjcf",
         .title = "Models for MuJoCo",
         .purpose = "a folder with a model of up to 2500 nodes and its texture, which MuJoCo loads",
         .write = writeMujoco,
         .holdsPictures = true,
         .isFolder = true,
         .isStepped = true,
         .differences = mujocoDifferences}};
    return all;
}

/// A name that is an ending and nothing else counts as having it, as where the name is asked for.
const Exporter& exporterFor(const std::filesystem::path& file) {
    const std::string name = inSmallLetters(file.filename().string());
    std::vector<std::string> endings;
    for (const Exporter& exporter : exporters()) {
        if (name.ends_with(exporter.ending)) return exporter;
        endings.push_back(exporter.ending);
    }
    if (!file.has_extension()) return exporters().front();
    throw FileError(file,
                    "has the ending of no format that there is; end its name in " + joined(endings, " or "));
}

namespace {

/// What is wrong with an organ is said of the file that would be written.
template<class Work> auto forFile(const std::filesystem::path& file, Work&& work) {
    try {
        return work();
    } catch (const InvalidModel& error) {
        throw FileError(file, std::string("was not exported: ") + error.what());
    }
}

} // namespace

void requireFree(const std::filesystem::path& file, const Exporter& exporter) {
    if (exporter.isFolder) requireNewFolder(file);
}

Handover handoverFor(const std::filesystem::path& file, const Project& project, const Progress& progress) {
    return forFile(file, [&] { return handoverOf(project, progress); });
}

Differences differencesOf(const Handover& handover, const Exporter& exporter, const HandoverMeans& means) {
    return exporter.differences ? exporter.differences(handover, means) : Differences{};
}

void exportHandover(const Handover& handover, const Exporter& exporter, const std::filesystem::path& file,
                    const HandoverMeans& means) {
    forFile(file, [&] { exporter.write(handover, file, means); });
}

std::vector<std::filesystem::path> exportedFiles(const std::filesystem::path& file) {
    if (!std::filesystem::is_directory(file)) return {file};
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(file))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void exportProject(const Project& project, const Exporter& exporter, const std::filesystem::path& file,
                   const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    const bool packs = !project.atlas && !project.layers.empty();
    const Handover handover = handoverFor(file, project, parts.next(packs ? 0.3 : 0.02));
    exportHandover(handover, exporter, file, withProgress(means, parts.rest()));
}

} // namespace esm
