#include "core/authoring/packing.h"

#include "core/support/errors.h"

namespace esm {

void pack(Project& project, const Progress& progress) {
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, project.texture.atlas, progress));
}

Atlas packFitting(const TriangleMesh& mesh, AtlasOptions options, const Progress& progress) {
    constexpr int largestSize = 8192;
    ProgressParts sizes(progress);
    for (;; options.size *= 2) {
        try {
            Atlas atlas = packAtlas(mesh, options, sizes.nextOfRest(0.8));
            reportProgress(progress, 1);
            return atlas;
        } catch (const InvalidModel&) {
            const bool hasSizeOfItsOwn = options.layout == AtlasLayout::Own; // no size would help
            if (hasSizeOfItsOwn || options.size * 2 > largestSize) throw;
        }
    }
}

void packIfNeeded(Project& project, const Progress& progress) {
    if (project.atlas) return;
    takeAtlas(project,
              std::make_shared<const Atlas>(packFitting(*project.mesh, project.texture.atlas, progress)));
}

void takeAtlas(Project& project, std::shared_ptr<const Atlas> atlas) {
    if (project.atlas) return;
    project.texture.atlas = atlas->options;
    project.atlas = std::move(atlas);
}

} // namespace esm
