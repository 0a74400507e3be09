#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/healing.h"
#include "core/texture/layers/lit_triangles.h"
#include "core/texture/layers/photo_fade.h"
#include "core/texture/layers/seen_sides.h"
#include "core/texture/layers/texel_owners.h"
#include "core/texture/layers/texture_layer.h"
#include "core/texture/photo/photo_sampler.h"

#include <memory>
#include <optional>
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

/// What a stroke that heals adapts to.
struct HealedStroke {
    std::shared_ptr<const BrushStroke> stroke;
    std::vector<TextureLayer> beneath; ///< all that are shown
    std::array<std::uint8_t, 3> baseColour;
    std::shared_ptr<const HealingRim> rim;
};

/// What is certain of a projector's light, see `certainLighting`, and what it falls on, see `seenSides`.
struct SurfaceLighting {
    std::vector<Lighting> triangles;
    std::vector<SeenSide> sides; ///< of the triangles
};

/// A projector and the photo in whose pixels it counts.
struct ProjectedSize {
    Projector projector;
    PhotoSize photo;

    bool operator==(const ProjectedSize&) const = default;
};

struct ProjectorLighting {
    ProjectedSize projected;
    std::shared_ptr<const SurfaceLighting> lighting;
};

/// How a photo fades towards outlines, see `outlineFeather`.
struct ProjectorOutlines {
    ProjectedSize projected;
    double blendPixels;
    std::shared_ptr<const PhotoFade> feather;
};

/// How a photo fades towards what is transparent of it, see `maskFeather`.
struct MaskedPicture {
    std::shared_ptr<const Image> picture;
    double blendPixels;
    std::shared_ptr<const PhotoFade> feather;
};

/// A photo that fades on the surface.
struct FadingPhoto {
    Projector projector;
    std::shared_ptr<const Image> picture;
    double blendPixels;
    bool atMask; ///< see `fadesAtMask`
};

/// What compositions of one surface make and the next one can use again. It changes no result. Nothing that
/// the last composition did not use is kept. For one thread.
class CompositionCache {
public:
    /// @param mesh the same as long as the cache lives
    std::shared_ptr<const SurfaceQuery> queryOf(const TriangleMesh& mesh);
    /// Of the last atlas that was asked for. @throws Cancelled
    std::shared_ptr<const TexelOwners> ownersOf(const TriangleMesh& mesh, const Atlas& atlas,
                                                const Progress& progress);
    SampledPicture sampled(const std::shared_ptr<const Image>& picture);
    /// @throws Cancelled
    std::shared_ptr<const SurfaceLighting> lightingOf(const ProjectedSize& projected,
                                                      const TriangleMesh& mesh, const Progress& progress);
    /// Towards outlines, where its projector asks what is hidden, and where asked for towards what is
    /// transparent of it. Null where nothing fades. @throws Cancelled
    std::shared_ptr<const PhotoFade> fadeOf(const FadingPhoto& photo, const TriangleMesh& mesh,
                                            const Progress& progress);
    /// See `seenSides`.
    std::vector<SeenSide> sidesOf(const Projector& projector, const TriangleMesh& mesh);
    /// Of the vertices, see `vertexNormals`.
    std::shared_ptr<const std::vector<Eigen::Vector3d>> normalsOf(const TriangleMesh& mesh);

    /// Nothing where no photo was blended so.
    std::optional<SampledPicture> banded(const TextureLayer& layer, const std::vector<TextureLayer>& beneath,
                                         std::array<std::uint8_t, 3> baseColour);
    void keep(BandedPicture picture) { m_banded.used.push_back(std::move(picture)); }

    /// Null where the stroke was not healed so.
    std::shared_ptr<const HealingRim> healed(const BrushStroke& stroke,
                                             const std::vector<TextureLayer>& beneath,
                                             std::array<std::uint8_t, 3> baseColour);
    void keep(HealedStroke stroke) { m_healed.used.push_back(std::move(stroke)); }

    /// Forgets what was not used since this was called before.
    void finish();

private:
    std::shared_ptr<const PhotoFade> outlinesOf(const ProjectedSize& projected, double blendPixels,
                                                const TriangleMesh& mesh, const Progress& progress);
    std::shared_ptr<const PhotoFade> maskFadeOf(const std::shared_ptr<const Image>& picture,
                                                double blendPixels, const Progress& progress);
    ShadowCaster shadowCaster(const TriangleMesh& mesh);

    template<typename Item> struct Generation { std::vector<Item> used, before; };

    std::shared_ptr<const SurfaceQuery> m_query;
    std::vector<Triangle> m_across; ///< of the mesh, once asked for
    std::optional<Parts> m_parts;   ///< the same
    std::shared_ptr<const std::vector<Eigen::Vector3d>> m_normals;
    std::shared_ptr<const TexelOwners> m_owners;
    Generation<SampledPicture> m_sampled;
    Generation<BandedPicture> m_banded;
    Generation<HealedStroke> m_healed;
    Generation<ProjectorLighting> m_lighting;
    Generation<ProjectorOutlines> m_outlines;
    Generation<MaskedPicture> m_masks;
};

} // namespace esm
