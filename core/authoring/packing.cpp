#include "core/authoring/packing.h"

#include "core/support/errors.h"

namespace esm {

void pack(Project& project) {
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, project.texture.atlas));
}

Atlas packFitting(const TriangleMesh& mesh, AtlasOptions options) {
    constexpr int largestSize = 8192;
    for (;; options.size *= 2) {
        try {
            return packAtlas(mesh, options);
        } catch (const InvalidModel&) {
            if (options.size * 2 > largestSize) throw;
        }
    }
}

void packIfNeeded(Project& project) {
    if (project.atlas) return;
    takeAtlas(project, std::make_shared<const Atlas>(packFitting(*project.mesh, project.texture.atlas)));
}

void takeAtlas(Project& project, std::shared_ptr<const Atlas> atlas) {
    if (project.atlas) return;
    project.texture.atlas = atlas->options;
    project.atlas = std::move(atlas);
}

} // namespace esm
