#include "core/exchange/project/project_version.h"

#include "core/exchange/project/model_json.h"

#include <algorithm>

namespace esm {

namespace {

bool needsPerspective(const TextureLayer& layer) {
    return layer.projector.kind == ProjectorKind::Perspective || layer.projector.falloff;
}

bool needsPainting(const TextureLayer& layer) {
    return !layer.photo || layer.blending != Blending::Normal || !layer.strokes.empty();
}

bool needsPreparation(const TextureLayer& layer) {
    return !layer.preparation.isNothing();
}

bool needsMask(const TextureLayer& layer) {
    return !layer.preparation.strokes.empty() || layer.preparation.match;
}

/// Fields other than circles, masks with outlines, and highlights by their surroundings.
bool needsShapedMask(const TextureLayer& layer) {
    const PhotoPreparation& preparation = layer.preparation;
    return (preparation.field && !preparation.field->isCircle()) || preparation.highlightSensitivity ||
           std::any_of(preparation.strokes.begin(), preparation.strokes.end(),
                       [](const PhotoStroke& stroke) { return stroke.isFilled; });
}

bool needsRetouching(const TextureLayer& layer) {
    const bool blendsAnew = layer.blending == Blending::Screen || layer.blending == Blending::Overlay ||
                            layer.blending == Blending::Colour;
    const bool isPaintedAnew =
        std::any_of(layer.strokes.begin(), layer.strokes.end(), [](const auto& stroke) {
            return !stroke->shares.empty() || stroke->kind == BrushKind::Heal;
        });
    return blendsAnew || isPaintedAnew || layer.preparation.adjustment != ColourAdjustment();
}

bool needsStretchedLayout(const Project& project) {
    return !project.mesh->textureCoordinates.empty() || isStretched(project.texture.atlas.layout) ||
           (project.atlas && isStretched(project.atlas->options.layout));
}

bool needsLandmarks(const TextureLayer& layer) {
    return !layer.landmarks.empty();
}

} // namespace

int projectVersionOf(const Project& project) {
    VersionNeeds needs = needsOf(project.regions, project.base, project.network->binding.has_value());
    for (const auto& spare : project.spareSystems) {
        needs.extendedInference = needs.extendedInference || needsExtendedInference(*spare);
        needs.clinicalUnits = needs.clinicalUnits || needsClinicalUnits(*spare);
    }
    const auto any = [&](auto&& needed) {
        return std::any_of(project.layers.begin(), project.layers.end(), needed);
    };
    needs.perspective = any(needsPerspective);
    needs.preparation = any(needsPreparation);
    needs.painting = any(needsPainting);
    needs.landmarks = any(needsLandmarks);
    needs.maskedPhotos = any(needsMask);
    needs.shapedMasks = any(needsShapedMask);
    needs.finish = project.texture.finish || project.texture.occlusionReach > 0 ||
                   any([](const TextureLayer& layer) { return layer.finish.has_value(); });
    needs.retouching = any(needsRetouching);
    needs.instruments = !hasPlainInstrument(project.scene);
    needs.fluids = !project.scene.fillings.empty() || !project.scene.pressures.empty();
    needs.splits = !project.scene.splits.empty();
    needs.wideBinding = project.network->binding && needsStarts(*project.network->binding);
    needs.lattice = project.network->lattice.has_value();
    needs.prisms = needs.lattice && isWall(project.network->lattice->filling);
    needs.graded = needs.lattice && project.network->lattice->filling.kind == LatticeKind::Graded;
    needs.sheet = project.network->sheet.has_value();
    needs.stretchedLayout = needsStretchedLayout(project);
    return versionOf(needs);
}

} // namespace esm
