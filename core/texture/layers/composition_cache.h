#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/lit_triangles.h"
#include "core/texture/layers/texel_owners.h"
#include "core/texture/layers/texture_layer.h"
#include "core/texture/photo/photo_sampler.h"

#include <memory>
#include <vector>

namespace esm {

/// A picture as it is projected, with its pyramid.
struct SampledPicture {
    std::shared_ptr<const Image> picture; ///< null without a photo
    std::shared_ptr<const PhotoSampler> sampler;
};

/// What a photo was blended into in bands.
struct BandedPicture {
    TextureLayer layer;
    std::vector<TextureLayer> beneath; ///< all that are shown
    std::array<std::uint8_t, 3> baseColour;
    SampledPicture blended;
};

/// What is certain of a projector's light, see `certainLighting`.
struct ProjectorLighting {
    Projector projector;
    int photoWidth, photoHeight; ///< pixels
    std::shared_ptr<const std::vector<Lighting>> lighting;
};

/// What compositions of one surface make and the next one can use again. It changes no result. Nothing that
/// the last composition did not use is kept. For one thread.
class CompositionCache {
public:
    /// @param mesh the same as long as the cache lives
    std::shared_ptr<const SurfaceQuery> queryOf(const TriangleMesh& mesh);
    /// Of the last atlas that was asked for. @throws Cancelled
    std::shared_ptr<const TexelOwners> ownersOf(const Atlas& atlas, const Progress& progress);
    SampledPicture sampled(const std::shared_ptr<const Image>& picture);
    /// @param tolerance m, the same as long as the cache lives
    /// @throws Cancelled
    std::shared_ptr<const std::vector<Lighting>> lightingOf(const Projector& projector, const Image& photo,
                                                            const TriangleMesh& mesh, double tolerance,
                                                            const Progress& progress);

    /// Nothing where no photo was blended so.
    std::optional<SampledPicture> banded(const TextureLayer& layer, const std::vector<TextureLayer>& beneath,
                                         std::array<std::uint8_t, 3> baseColour);
    void keep(BandedPicture picture) { m_banded.used.push_back(std::move(picture)); }

    /// Forgets what was not used since this was called before.
    void finish();

private:
    template<typename Item> struct Generation { std::vector<Item> used, before; };

    std::shared_ptr<const SurfaceQuery> m_query;
    std::vector<Triangle> m_across; ///< of the mesh, once asked for
    std::shared_ptr<const TexelOwners> m_owners;
    Generation<SampledPicture> m_sampled;
    Generation<BandedPicture> m_banded;
    Generation<ProjectorLighting> m_lighting;
};

} // namespace esm
