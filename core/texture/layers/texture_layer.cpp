#include "core/texture/layers/texture_layer.h"

#include "core/support/offenders.h"
#include "core/texture/texture_limits.h"

#include <algorithm>

namespace esm {

namespace {

bool paints(const std::shared_ptr<const BrushStroke>& stroke) {
    return laysColour(stroke->kind);
}

std::size_t pointCount(const BrushStrokes& strokes) {
    std::size_t points = 0;
    for (const auto& stroke : strokes)
        points += stroke->path.size();
    return points;
}

} // namespace

std::shared_ptr<const Image> pictureOf(const TextureLayer& layer) {
    if (layer.prepared) return layer.prepared;
    if (!layer.photo) return nullptr;
    return {layer.photo, &layer.photo->image}; // the photo owns both
}

/// Pictures never change once made, so that two are the same where they are one. What the preparation says
/// and where landmarks lie is not asked: both are in the picture and the projector already.
bool projectsTheSame(const TextureLayer& a, const TextureLayer& b) {
    return pictureOf(a) == pictureOf(b) && a.projector == b.projector && a.blendPixels == b.blendPixels;
}

bool looksTheSame(const TextureLayer& a, const TextureLayer& b) {
    return projectsTheSame(a, b) && a.opacity == b.opacity && a.visible == b.visible &&
           a.blending == b.blending && a.strokes == b.strokes;
}

bool fadesAtMask(const TextureLayer& layer) {
    return layer.prepared && layer.preparation.leavesOut() && layer.blending != Blending::MultiBand;
}

bool isLaid(const TextureLayer& layer) {
    if (!layer.visible || !(layer.opacity > 0)) return false;
    if (layer.photo) return !layer.photo->image.empty();
    return std::any_of(layer.strokes.begin(), layer.strokes.end(), paints);
}

bool isShown(const TextureLayer& layer) {
    return isLaid(layer) && !(layer.finish && layer.finish->hidesColour);
}

std::vector<std::string> paintingProblems(const TextureLayer& layer) {
    std::vector<std::string> problems;
    if (!layer.photo && layer.blending == Blending::MultiBand)
        problems.emplace_back("only a photo can be blended in bands");
    if (layer.photo && std::any_of(layer.strokes.begin(), layer.strokes.end(), paints))
        problems.emplace_back("colours are painted on a photo; they need a layer of their own");
    if (layer.strokes.size() > texture_limits::mostStrokes ||
        pointCount(layer.strokes) > texture_limits::mostBrushPoints)
        problems.push_back("more was painted on it than the " + std::to_string(texture_limits::mostStrokes) +
                           " strokes or " + std::to_string(texture_limits::mostBrushPoints) +
                           " points that a layer can hold; begin another layer");
    for (std::size_t i = 0; i < layer.strokes.size(); ++i)
        addUnder(problems, "stroke " + std::to_string(i + 1), validate(*layer.strokes[i]));
    return problems;
}

/// The picture is made before the layer is touched: where that fails the layer stays as it was.
void prepare(TextureLayer& layer, const PhotoPreparation& preparation, const Progress& progress) {
    std::shared_ptr<const Image> picture;
    if (!preparation.isNothing())
        picture = std::make_shared<const Image>(prepared(layer.photo->image, preparation, progress));
    layer.preparation = preparation;
    layer.prepared = std::move(picture);
}

} // namespace esm
