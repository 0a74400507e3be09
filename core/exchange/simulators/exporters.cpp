#include "core/exchange/simulators/exporters.h"

#include "core/exchange/model_package.h"
#include "core/exchange/simulators/sofa/sofa_folder.h"
#include "core/exchange/simulators/vtp_file.h"
#include "core/support/errors.h"
#include "core/support/joined.h"
#include "core/support/letters.h"

namespace esm {

const std::vector<Exporter>& exporters() {
    static const std::vector<Exporter> all{
        {"glb", ".glb", "Model packages", "the model package for simulators, a textured mesh to any viewer",
         writePackage, true},
        {"vtp", ".vtp", "VTK surfaces",
         "surface and springs with their parameters as arrays, for ParaView and 3D Slicer", writeVtp},
        {.name = "sofa",
         .ending = ".sofa",
         .title = "Scenes for SOFA",
         .purpose = "a folder with a scene, springs, surface and texture, which SOFA loads",
         .write = writeSofa,
         .holdsPictures = true,
         .isFolder = true,
         .isStepped = true,
         .differences = sofaDifferences}};
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

/// What an exporter can say of a handover is said of the file that would be written.
template<class Work> auto forFile(const std::filesystem::path& file, Work&& work) {
    try {
        return work();
    } catch (const InvalidModel& error) {
        throw FileError(file, std::string("was not exported: ") + error.what());
    }
}

Handover preparedHandover(const Project& project, ProgressParts& parts) {
    const bool packs = !project.atlas && !project.layers.empty();
    return handoverOf(project, parts.next(packs ? 0.3 : 0.02));
}

Differences toldDifferences(const Exporter& exporter, const Handover& handover, const HandoverMeans& means) {
    return exporter.differences ? exporter.differences(handover, means) : Differences{};
}

} // namespace

Differences exportProject(const Project& project, const Exporter& exporter, const std::filesystem::path& file,
                          const HandoverMeans& means) {
    return forFile(file, [&] {
        ProgressParts parts(means.progress);
        const Handover handover = preparedHandover(project, parts);
        HandoverMeans rest = means;
        rest.progress = exporter.differences ? parts.next(0.1) : Progress{};
        Differences differences = toldDifferences(exporter, handover, rest);
        rest.progress = parts.rest();
        exporter.write(handover, file, rest);
        return differences;
    });
}

Differences differencesOf(const Project& project, const Exporter& exporter, const std::filesystem::path& file,
                          const HandoverMeans& means) {
    return forFile(file, [&] {
        ProgressParts parts(means.progress);
        const Handover handover = preparedHandover(project, parts);
        HandoverMeans rest = means;
        rest.progress = parts.rest();
        return toldDifferences(exporter, handover, rest);
    });
}

} // namespace esm
