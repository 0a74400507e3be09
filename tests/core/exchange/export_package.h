#pragma once

#include "core/exchange/model_package.h"
#include "core/exchange/simulators/exporters.h"

namespace esm {

inline HandoverMeans saidBy(const Authorship& authorship) {
    HandoverMeans means;
    means.authorship = authorship;
    return means;
}

inline void exportPackage(const Project& project, const std::filesystem::path& file,
                          const HandoverMeans& means = {}) {
    exportProject(project, exporterFor("organ.glb"), file, means);
}

} // namespace esm
