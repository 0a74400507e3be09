#pragma once

#include "core/support/progress.h"
#include "core/texture/layers/composition_cache.h"
#include "core/texture/layers/layer_projection.h"

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

namespace esm {

using Patch = std::array<Eigen::Vector2d, 3>; ///< a triangle's corners in a picture, pixels

/// A layer with what is made once for all its triangles.
struct PreparedLayer {
    TextureLayer layer;
    SampledPicture projected;                        ///< as it is, or blended in bands
    std::optional<LayerPhoto> photo;                 ///< that picture; none in a layer that is only painted
    std::shared_ptr<const SurfaceLighting> lighting; ///< null where none is asked for
    std::shared_ptr<const PhotoFade> fade;           ///< null where nothing fades
    std::vector<Eigen::AlignedBox3d> strokeReach;    ///< of each stroke
    std::vector<std::shared_ptr<const HealingRim>> rims; ///< the same; null but of those that heal
};

/// What a photo's strokes make of its mask, painted over white: black where it is erased.
TextureLayer paintedMask(const BrushStrokes& strokes);

class LayerOnTriangle;
class TriangleLayers;

/// The layers that are shown on a surface, and what all threads share that ask for their colours. Immutable.
class LayerStack {
public:
    /// @param mesh outlives the stack
    /// @param patches outlive the stack; each triangle's place in the picture whose pixels are asked for, by
    /// whose size photos are read
    /// @throws Cancelled
    LayerStack(const TriangleMesh& mesh, const std::vector<Patch>& patches,
               const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
               CompositionCache& cache, const Progress& progress = {});
    LayerStack(const LayerStack&) = delete;
    LayerStack& operator=(const LayerStack&) = delete;

    bool isEmpty() const { return m_layers.empty(); }
    const LitSurface& surface() const { return m_surface; }
    const Eigen::Vector3f& baseColour() const { return m_baseColour; }

    /// Red, green, blue, 0 to 255, of the surface nearest to a point, made by the lowest layers.
    /// @param layers how many
    /// @param follows how many copies of copies are followed
    /// @param known triangles that were asked for before
    Eigen::Vector3f
    colourNear(const Eigen::Vector3d& point, std::size_t layers, int follows,
               std::unordered_map<std::uint32_t, std::unique_ptr<TriangleLayers>>& known) const;

private:
    friend class TriangleLayers;

    /// The same layers seen in another picture.
    LayerStack(const LayerStack& stack, const std::vector<Patch>& patches);
    SampledPicture blendedInBands(const PreparedLayer& layer, CompositionCache& cache,
                                  const Progress& progress) const;

    HealingRim rimOf(const BrushStroke& stroke) const;
    /// Of each stroke that heals what the layers so far show, which are `beneath`.
    std::vector<std::shared_ptr<const HealingRim>> rimsOf(const BrushStrokes& strokes,
                                                          const std::vector<TextureLayer>& beneath,
                                                          std::array<std::uint8_t, 3> baseColour,
                                                          CompositionCache& cache) const;

    LitSurface m_surface;
    const std::vector<Patch>& m_patches;
    Eigen::Vector3f m_baseColour;
    std::shared_ptr<const SurfaceQuery> m_query;                   ///< null where nothing asks for it
    std::shared_ptr<const std::vector<Eigen::Vector3d>> m_normals; ///< null without layers
    std::vector<std::shared_ptr<const PreparedLayer>> m_layers;
};

/// One layer as the patch of one triangle sees it.
class LayerOnTriangle {
public:
    /// The weight is that of the photo × mask, or what is painted × mask × opacity.
    LayerColour at(const PatchTexel& texel) const;
    Blending blending() const { return m_prepared->layer.blending; }

private:
    friend class TriangleLayers;

    LayerColour painted(const SurfacePoint& point) const;
    float mask(const SurfacePoint& point) const;
    SurfacePoint pointAt(const Eigen::Vector3d& weights) const;
    Eigen::Vector3f colourOf(std::size_t stroke, const Eigen::Vector3d& point) const;

    const LayerStack* m_stack = nullptr;
    const PreparedLayer* m_prepared = nullptr;
    std::size_t m_place = 0;              ///< in the stack
    int m_follows = 0;                    ///< copies of copies
    Eigen::Matrix3d m_corners, m_normals; ///< as columns
    std::optional<TriangleProjection> m_projection;
    std::vector<StrokeOnTriangle> m_strokes;
    std::vector<const HealingRim*> m_rims; ///< of each of them; null but of those that heal
    mutable std::unordered_map<std::uint32_t, std::unique_ptr<TriangleLayers>> m_sources; ///< of clones
};

/// The layers that may reach one triangle, from the lowest to the topmost. For one thread.
class TriangleLayers {
public:
    /// Copies of copies that are followed: enough for any painting, and a bound for what a file may ask for.
    static constexpr int deepestClone = 3;

    TriangleLayers(const LayerStack& stack, std::uint32_t triangle)
        : TriangleLayers(stack, triangle, stack.m_layers.size(), deepestClone) {}
    /// Of the lowest layers only, how many.
    TriangleLayers(const LayerStack& stack, std::uint32_t triangle, std::size_t layers, int follows);

    const std::vector<LayerOnTriangle>& layers() const { return m_layers; }

    /// Red, green, blue, 0 to 255. Mixed in sRGB values, as the source does and as picture editors do.
    Eigen::Vector3f colour(const PatchTexel& texel) const { return colourOfLowest(m_layers.size(), texel); }

private:
    Eigen::Vector3f colourOfLowest(std::size_t layers, const PatchTexel& texel) const;
    std::optional<LayerOnTriangle> reaching(std::size_t place, std::uint32_t triangle, int follows) const;

    const LayerStack* m_stack;
    std::vector<LayerOnTriangle> m_layers;
};

} // namespace esm
