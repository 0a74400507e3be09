#pragma once

#include "core/exchange/model_package.h"
#include "core/exchange/simulators/exporters.h"

namespace esm {

inline void exportPackage(const Project& project, const std::filesystem::path& file,
                          const HandoverMeans& means = {}) {
    exportProject(project, exporterFor("organ.glb"), file, means);
}

} // namespace esm
