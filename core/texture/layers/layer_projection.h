#pragma once

#include "core/surface/surface_query.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/layers/photo_fade.h"
#include "core/texture/layers/seen_sides.h"
#include "core/texture/layers/texture_layer.h"
#include "core/texture/photo/photo_sampler.h"

#include <optional>

namespace esm {

/// The surface that a projector's light meets.
struct LitSurface {
    const TriangleMesh& mesh;
    const SurfaceQuery* query; ///< null when no layer asks what is hidden
    double tolerance;          ///< m, how far surface may lie before another without hiding it
    const std::vector<Eigen::Vector3d>* normals; ///< of the vertices, length 1; null without any layer
};

struct LitTriangle {
    std::uint32_t triangle;
    SeenSide side;
    bool isLit; ///< nothing hides any of it, see `certainLighting`
};

/// What a layer lays on a texel.
struct LayerColour {
    Eigen::Vector4f colour; ///< red, green, blue, 0 to 255; the last has no meaning
    float weight;           ///< 0 to 1
};

/// A layer's photo and how it is projected.
struct LayerPhoto {
    const TextureLayer& layer;
    const PhotoSampler& sampler;
    Eigen::Matrix4d matrix; ///< as `photoMatrix` gives it
    const PhotoFade* fade;  ///< null where nothing fades
};

/// The photo of a layer as the patch of one triangle sees it.
class TriangleProjection {
public:
    /// Nothing when no point of the patch can take colour from the layer.
    /// @param photo outlives the projection, as the surface does
    static std::optional<TriangleProjection> make(const LayerPhoto& photo, const LitSurface& surface,
                                                  const LitTriangle& triangle,
                                                  const std::array<Eigen::Vector2d, 3>& patch);

    /// Its weight is opacity × border × alpha × that of the angle; 0 where the photo's light does not come.
    LayerColour at(const PatchTexel& texel) const;

private:
    TriangleProjection(const LayerPhoto& photo, const LitSurface& surface, const LitTriangle& triangle);

    bool isParallel() const { return m_layer.projector.kind == ProjectorKind::Parallel; }
    bool isTurnedAway() const;
    bool facesLight() const;
    void findClearPart(const Eigen::Vector3d& densities);
    bool isInClearPart(double x, double y) const;
    bool mayTakeColour(const Eigen::Vector3d& densities) const;
    double depthAt(const Eigen::Vector4d& seen, const Eigen::Vector3d& weights) const;
    double borderWeight(double x, double y) const;
    double lightWeight(const Eigen::Vector3d& nearest) const;
    double angleWeightAt(const Eigen::Vector3d& nearest, const Eigen::Vector3d& towardsLight) const;
    double weightOfCosine(double cosine) const;
    double seenShare(const Eigen::Vector3d& nearest, const Eigen::Vector3d& towardsLight) const;
    Eigen::Vector3d towardsLight(const Eigen::Vector3d& point) const; ///< of length 1

    const LayerPhoto& m_photo;
    const TextureLayer& m_layer;
    const PhotoSampler& m_sampler;
    const LitSurface& m_surface;
    Eigen::Matrix3d m_corners;                   ///< as columns, m
    Eigen::Matrix<double, 4, 3> m_places;        ///< of the corners, as columns: as `photoMatrix` gives them
    Eigen::Matrix<double, 3, 2> m_placePerTexel; ///< how the first three of them change over the patch
    Eigen::Matrix3d m_normals;                   ///< outward at the corners, of length 1
    SeenSide m_side;
    Eigen::Vector3d m_depths;     ///< in the pyramid, at the corners
    bool m_isDepthLinear = false; ///< over the patch, nearly
    bool m_isLit = false;         ///< nothing hides any of it
    bool m_facesLight = false;    ///< the angle takes nothing from any of it
    /// Corners of a part of the photo, pixels, without an outline near; at first of none.
    Eigen::Vector2d m_clearLow{1, 1}, m_clearHigh{0, 0};
};

} // namespace esm
