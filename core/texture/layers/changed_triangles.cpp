#include "core/texture/layers/changed_triangles.h"

#include "core/support/parallel_steps.h"

#include <algorithm>

namespace esm {

namespace {

using Layers = std::vector<TextureLayer>;

Layers shownOf(const Layers& layers) {
    Layers shown;
    std::copy_if(layers.begin(), layers.end(), std::back_inserter(shown), isShown);
    return shown;
}

bool sameBesidesStrokes(const TextureLayer& a, const TextureLayer& b) {
    return projectsTheSame(a, b) && a.opacity == b.opacity && a.blending == b.blending;
}

/// Longest common subsequence (dynamic programming from the end, as in text books): a layer that was moved,
/// added or removed then differs alone, and those above and beneath it stay paired. length[i][j] is what
/// before[i…] and after[j…] have in common. Strokes are left out of the comparison, since of a layer that was
/// painted on only the new strokes reach anything.
std::vector<std::vector<std::size_t>> commonLengths(const Layers& before, const Layers& after) {
    std::vector<std::vector<std::size_t>> length(before.size() + 1,
                                                 std::vector<std::size_t>(after.size() + 1, 0));
    for (std::size_t i = before.size(); i-- > 0;)
        for (std::size_t j = after.size(); j-- > 0;)
            length[i][j] = sameBesidesStrokes(before[i], after[j])
                               ? length[i + 1][j + 1] + 1
                               : std::max(length[i + 1][j], length[i][j + 1]);
    return length;
}

/// Whether a layer's colour depends on more than the texel beneath it.
bool looksAround(const TextureLayer& layer) {
    return layer.blending == Blending::MultiBand ||
           std::any_of(layer.strokes.begin(), layer.strokes.end(),
                       [](const auto& stroke) { return copies(stroke->kind); });
}

/// A stroke that reaches as far, and looks nowhere else.
std::shared_ptr<const BrushStroke> asColour(const BrushStroke& stroke) {
    BrushStroke painted = stroke;
    painted.kind = BrushKind::Colour;
    return std::make_shared<const BrushStroke>(std::move(painted));
}

/// What strokes were added or taken away. They come and go at the end of the list, so all behind the first
/// difference are taken for changed. As colour strokes of a layer that is only painted they reach just as
/// far, and need no photo.
void addChangedStrokes(const TextureLayer& before, const TextureLayer& after, Layers& changed) {
    const auto [mine, theirs] =
        std::mismatch(before.strokes.begin(), before.strokes.end(), after.strokes.begin(),
                      after.strokes.end(), [](const auto& a, const auto& b) { return a == b || *a == *b; });
    BrushStrokes differing(mine, before.strokes.end());
    differing.insert(differing.end(), theirs, after.strokes.end());
    TextureLayer reach;
    for (const auto& stroke : differing)
        reach.strokes.push_back(asColour(*stroke));
    changed.push_back(std::move(reach));
}

/// Layers that reach all that may have changed. Both lists are gone through side by side, as a text
/// comparison does: what is in one alone has changed. A layer that is in both has changed too where it looks
/// at its surroundings, by a clone or by bands, and anything beneath it has changed: how far that is carried
/// is not asked, all that it reaches is composed anew.
Layers changedLayers(const Layers& before, const Layers& after) {
    const auto common = commonLengths(before, after);
    Layers changed;
    std::size_t i = 0, j = 0;
    while (i < before.size() || j < after.size()) {
        if (i < before.size() && j < after.size() && sameBesidesStrokes(before[i], after[j])) {
            const bool isMasked = !(before[i].strokes == after[j].strokes);
            const bool movesBands = isMasked && after[j].blending == Blending::MultiBand;
            if (movesBands || (!changed.empty() && (looksAround(before[i]) || looksAround(after[j]))))
                changed.insert(changed.end(), {before[i], after[j]});
            else if (isMasked)
                addChangedStrokes(before[i], after[j], changed);
            ++i, ++j;
        } else if (j == after.size() || (i < before.size() && common[i + 1][j] >= common[i][j + 1])) {
            changed.push_back(before[i++]);
        } else {
            changed.push_back(after[j++]);
        }
    }
    for (TextureLayer& layer : changed) {
        layer.blending = Blending::Normal; // which decides no reach, nor does what fades within it
        layer.preparation = {};
        for (auto& stroke : layer.strokes)
            if (copies(stroke->kind)) stroke = asColour(*stroke);
    }
    return changed;
}

} // namespace

TriangleMarks changedTriangles(const TriangleMesh& mesh, const std::vector<Patch>& patches,
                               const Layers& before, const Layers& after, CompositionCache& cache,
                               const Progress& progress) {
    ProgressParts parts(progress);
    TriangleMarks marks(mesh.triangles.size(), 0);
    const LayerStack changed(mesh, patches, changedLayers(shownOf(before), shownOf(after)), {}, cache,
                             parts.next(0.5));
    forEachInBlocks(marks.size(), trianglesPerBlock, parts.rest(), [&](std::size_t triangle) {
        const TriangleLayers layers(changed, static_cast<std::uint32_t>(triangle));
        marks[triangle] = layers.layers().empty() ? 0 : 1;
    });
    return marks;
}

} // namespace esm
