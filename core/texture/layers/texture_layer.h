#pragma once

#include "core/support/id.h"
#include "core/texture/finish/surface_finish.h"
#include "core/texture/layers/blending.h"
#include "core/texture/layers/brush_stroke.h"
#include "core/texture/photo/photo.h"
#include "core/texture/photo/photo_preparation.h"
#include "core/texture/projection/landmark_pair.h"
#include "core/texture/projection/projector.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// A photo on the organ, or what was painted there. Never baked in: layers are composed anew when one
/// changes.
struct TextureLayer : Identified<TextureLayer> {
    std::string name;
    std::shared_ptr<const Photo> photo; ///< null in a layer that is only painted
    Projector projector;
    /// Photo pixels over which the weight rises from 0 at the border, or at what is left out, to 1 [R 4.3.3].
    double blendPixels = 24;
    double opacity = 1; ///< 0 to 1
    bool visible = true;
    PhotoPreparation preparation;
    Derived<Image> prepared; ///< what it makes of the photo; null where it does nothing
    Blending blending = Blending::Normal;
    /// In the order in which they were painted. Erasing and restoring ones make the layer's mask; colour and
    /// clone brushes are for layers without a photo, where painting over what was erased shows again.
    BrushStrokes strokes;
    std::vector<LandmarkPair> landmarks; ///< that place the photo, in pixels of the projected picture
    std::optional<LayerFinish> finish;   ///< of what it covers; without one that of what lies beneath shows

    bool operator==(const TextureLayer&) const = default;
};
using LayerId = Id<TextureLayer>;
template<>
inline constexpr auto fieldsOf<TextureLayer> = fieldTable(
    field("name", &TextureLayer::name), field("file", &TextureLayer::photo).whenSet(),
    field("projector", &TextureLayer::projector),
    field("blendPixels", &TextureLayer::blendPixels, amountLimits("the blending width")),
    field("opacity", &TextureLayer::opacity, Limits<double>{"the opacity", 0, 1}),
    field("visible", &TextureLayer::visible), field("preparation", &TextureLayer::preparation).whenSet(),
    field("blending", &TextureLayer::blending).whenSet(), field("strokes", &TextureLayer::strokes).whenSet(),
    field("landmarks", &TextureLayer::landmarks).whenSet(), field("finish", &TextureLayer::finish).whenSet());

/// What is projected: the prepared picture, or the photo's own; null without a photo.
std::shared_ptr<const Image> pictureOf(const TextureLayer& layer);

/// Whether two layers project the same picture in the same way.
bool projectsTheSame(const TextureLayer& a, const TextureLayer& b);

/// Whether two layers show the same colours, whatever their names and their finish.
bool looksTheSame(const TextureLayer& a, const TextureLayer& b);

/// Whether a layer's photo fades towards what is masked of it, as towards its sides: where preparing it
/// leaves parts out. A photo whose file alone is transparent somewhere was drawn so, and where one is blended
/// in bands its colours agree with those beneath.
bool fadesAtMask(const TextureLayer& layer);

/// Whether a layer may lie somewhere on the surface, though perhaps without its colour.
bool isLaid(const TextureLayer& layer);

/// Whether a layer's colour can be seen anywhere.
bool isShown(const TextureLayer& layer);

/// Every problem of how a layer blends and of what was painted on it. Empty when all is well.
std::vector<std::string> paintingProblems(const TextureLayer& layer);

/// Gives a layer another preparation and the picture that comes of it, or leaves it as it was. Precondition:
/// it has a photo, or nothing is done to it.
/// @throws InvalidModel with what validate() finds
void prepare(TextureLayer& layer, const PhotoPreparation& preparation, const Progress& progress = {});

} // namespace esm
