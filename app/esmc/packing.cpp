#include "app/esmc/packing.h"

namespace esm {

void pack(Project& project) {
    project.atlas = std::make_shared<const Atlas>(packAtlas(*project.mesh, project.texture.atlas));
}

void packIfNeeded(Project& project) {
    if (!project.atlas) pack(project);
}

} // namespace esm
