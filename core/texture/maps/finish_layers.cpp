#include "core/texture/maps/finish_layers.h"

#include <algorithm>

namespace esm {

namespace {

bool lendsFinish(const TextureLayer& layer) {
    return layer.finish && isLaid(layer);
}

/// All that is laid has the layer's finish, whatever its colour and wherever that comes from.
BrushStrokes strokesOf(const TextureLayer& layer) {
    const FinishColour colour = finishColour(layer.finish->surface);
    BrushStrokes strokes;
    strokes.reserve(layer.strokes.size());
    for (const auto& stroke : layer.strokes) {
        if (!laysColour(stroke->kind)) {
            strokes.push_back(stroke);
            continue;
        }
        BrushStroke laid = *stroke;
        laid.kind = BrushKind::Colour;
        laid.colour = colour;
        laid.shift.setZero();
        strokes.push_back(std::make_shared<const BrushStroke>(std::move(laid)));
    }
    return strokes;
}

} // namespace

/// What was found for another finish of the same picture is taken over; only what was not asked for then is
/// looked for.
FilmAndHeights FinishPictures::filmAndHeightsOf(const TextureLayer& layer, const Progress& progress) const {
    const std::shared_ptr<const Image> shown = pictureOf(layer);
    FilmAndHeights found;
    for (const std::vector<Made>* known : {&m_before, &m_used})
        for (const Made& made : *known) {
            if (made.shown != shown || made.preparation != layer.preparation) continue;
            if (made.found.film) found.film = made.found.film;
            if (made.found.heights) found.heights = made.found.heights;
        }
    reportProgress(progress, 0);
    if (layer.finish->wetAtHighlights > 0 && !found.film)
        found.film =
            std::make_shared<const std::vector<std::uint8_t>>(filmOf(layer.photo->image, layer.preparation));
    reportProgress(progress, 0.5);
    if (layer.finish->relief > 0 && !found.heights)
        found.heights = std::make_shared<const std::vector<std::int8_t>>(heightsOf(*shown));
    reportProgress(progress, 1);
    return found;
}

std::shared_ptr<const Image> FinishPictures::of(const TextureLayer& layer, double greatestHeight,
                                                const Progress& progress) {
    const std::shared_ptr<const Image> shown = pictureOf(layer);
    const auto isOfThis = [&](const Made& made) {
        return made.shown == shown && made.preparation == layer.preparation && made.finish == *layer.finish &&
               (made.greatestHeight == greatestHeight || !(layer.finish->relief > 0));
    };
    for (const std::vector<Made>& known : {std::cref(m_used), std::cref(m_before)}) {
        const auto made = std::find_if(known.begin(), known.end(), isOfThis);
        if (made == known.end()) continue;
        std::shared_ptr<const Image> picture = made->picture;
        if (&known == &m_before) m_used.push_back(*made);
        return picture;
    }
    const FilmAndHeights found = filmAndHeightsOf(layer, progress);
    auto picture = std::make_shared<const Image>(finishPicture(*shown, found, *layer.finish, greatestHeight));
    // Stopped work goes on with the next wish: of a photo only the newest is of use.
    const auto ofThis = [&](const Made& made) { return made.layer == layer.id; };
    m_used.erase(std::remove_if(m_used.begin(), m_used.end(), ofThis), m_used.end());
    m_used.push_back({layer.id, shown, layer.preparation, found, *layer.finish, greatestHeight, picture});
    return picture;
}

void FinishPictures::forgetUnused() {
    m_before = std::move(m_used);
    m_used.clear();
}

bool hasFinish(const std::vector<TextureLayer>& layers, const std::optional<SurfaceFinish>& base) {
    return base || std::any_of(layers.begin(), layers.end(), lendsFinish);
}

/// A layer's own blending mixes colours; a finish always takes the place of what lies beneath by the same
/// weight.
FinishLayers finishLayers(const std::vector<TextureLayer>& layers, const std::optional<SurfaceFinish>& base,
                          FinishPictures& pictures, const Progress& progress) {
    FinishLayers made;
    made.base = finishColour(base.value_or(SurfaceFinish{}));
    for (const TextureLayer& layer : layers)
        if (lendsFinish(layer)) made.greatestHeight = std::max(made.greatestHeight, layer.finish->relief);
    ProgressParts parts(progress);
    for (const TextureLayer& layer : layers) {
        const Progress ofLayer = parts.next(1.0 / static_cast<double>(layers.size()));
        if (!lendsFinish(layer)) continue;
        TextureLayer lends = layer;
        lends.blending = Blending::Normal;
        if (layer.photo)
            lends.prepared = pictures.of(layer, made.greatestHeight, ofLayer);
        else
            lends.strokes = strokesOf(layer);
        lends.finish.reset();
        made.layers.push_back(std::move(lends));
    }
    pictures.forgetUnused();
    reportProgress(progress, 1);
    return made;
}

std::vector<std::string> finishWarnings(const TextureLayer& layer) {
    if (!layer.finish) return {};
    const LayerFinish& finish = *layer.finish;
    std::vector<std::string> warnings;
    if (!layer.photo && (finish.relief > 0 || finish.wetAtHighlights > 0))
        warnings.emplace_back("relief and wetness at highlights come from a photo, and this layer has none");
    if (layer.photo && finish.relief > 0 && !hasDetail(*pictureOf(layer)))
        warnings.emplace_back(
            "its photo is of one colour: there is no detail from which a relief could be guessed");
    return warnings;
}

} // namespace esm
