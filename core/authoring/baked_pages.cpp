#include "core/authoring/baked_pages.h"

#include "core/texture/layers/composite.h"
#include "core/texture/maps/finish_pages.h"

namespace esm {

BakedPages bakedPages(const Project& project, const Progress& progress) {
    if (!project.atlas) return {};
    ProgressParts parts(progress);
    const TextureSettings& settings = project.texture;
    const bool shines = hasFinish(project.layers, std::nullopt);
    auto colours = std::make_shared<const std::vector<Image>>(composite(
        *project.mesh, *project.atlas, project.layers, settings.baseColour, parts.next(shines ? 0.5 : 1)));
    return {std::move(colours),
            finishPages(*project.mesh, *project.atlas, project.layers, settings.finish, parts.rest())};
}

} // namespace esm
