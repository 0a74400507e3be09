#include "core/exchange/simulators/exporters.h"

#include "core/exchange/model_package.h"
#include "core/exchange/simulators/vtp_file.h"
#include "core/support/errors.h"

#include <algorithm>

namespace esm {

const std::vector<Exporter>& exporters() {
    static const std::vector<Exporter> all{
        {"glb", ".glb", "Model packages", "the model package for simulators, a textured mesh to any viewer",
         writePackage},
        {"vtp", ".vtp", "VTK surfaces",
         "surface and springs with their parameters as arrays, for ParaView and 3D Slicer", writeVtp}};
    return all;
}

const Exporter* exporterNamed(const std::string& name) {
    const auto& all = exporters();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Exporter& exporter) { return exporter.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const Exporter& exporterFor(const std::filesystem::path& file) {
    const auto& all = exporters();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Exporter& exporter) {
        return file.extension() == exporter.ending;
    });
    return found == all.end() ? all.front() : *found;
}

void exportProject(const Project& project, const Exporter& exporter, const std::filesystem::path& file,
                   const HandoverMeans& means) {
    try {
        exporter.write(handoverOf(project), file, means);
    } catch (const InvalidModel& error) {
        throw FileError(file, std::string("was not exported: ") + error.what());
    }
}

} // namespace esm
