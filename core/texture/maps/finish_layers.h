#pragma once

#include "core/support/progress.h"
#include "core/texture/finish/finish_picture.h"
#include "core/texture/layers/texture_layer.h"

#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// The layers that lend the surface a finish, each showing that instead of its colour, see FinishColour.
/// Composed as colours are, they give the finish of every texel: borders, masks, what is hidden and what lies
/// over what are the same for both.
struct FinishLayers {
    std::vector<TextureLayer> layers;
    FinishColour base{};
    double greatestHeight = 0; ///< m, that blue can say; 0 without a relief
};

/// The pictures of finishes that were made before, so that each is made once, and what their photos tell
/// once for all of them: those asked for since forgetUnused() was called last, and those of the round before.
class FinishPictures {
public:
    /// Precondition: the layer has a photo and a finish. @throws Cancelled
    std::shared_ptr<const Image> of(const TextureLayer& layer, double greatestHeight,
                                    const Progress& progress);
    void forgetUnused();

private:
    struct Made {
        LayerId layer;
        std::shared_ptr<const Image> shown;
        PhotoPreparation preparation;
        FilmAndHeights found;
        LayerFinish finish;
        double greatestHeight;
        std::shared_ptr<const Image> picture;
    };
    FilmAndHeights filmAndHeightsOf(const TextureLayer& layer, const Progress& progress) const;

    std::vector<Made> m_used, m_before;
};

/// Whether the surface has any finish: one of its own, or of a layer that can be seen.
bool hasFinish(const std::vector<TextureLayer>& layers, const std::optional<SurfaceFinish>& base);

/// @param base of the surface itself; tissue is dry and rough without one
/// @throws Cancelled
FinishLayers finishLayers(const std::vector<TextureLayer>& layers, const std::optional<SurfaceFinish>& base,
                          FinishPictures& pictures, const Progress& progress = {});

/// What of a layer's finish has no effect, for people: relief from a photo of one colour, anything of a photo
/// in a layer without one.
std::vector<std::string> finishWarnings(const TextureLayer& layer);

} // namespace esm
