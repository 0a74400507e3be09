#include "core/texture/layers/surface_beneath.h"

#include "core/support/parallel_steps.h"
#include "core/texture/layers/layer_stack.h"
#include "core/texture/layers/plane_rays.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr int rowsPerTask = 8;

/// Rows of a picture, and the layers on the triangles that they meet. Neighbouring rays meet the same
/// triangles: what is made for one is kept for the eight rows of a strip.
class SeenRows {
public:
    SeenRows(const LayerStack& stack, const PlaneRays& rays) : m_stack(stack), m_rays(rays) {}

    void fill(int firstRow, int endRow, Image& picture) {
        for (int y = firstRow; y < endRow; ++y)
            for (int x = 0; x < picture.width; ++x)
                if (const auto hit = m_rays.hit(x, y)) show(*hit, picture.at(x, y));
    }

private:
    void show(const RayHit& hit, std::uint8_t* pixel) {
        const auto layers = m_known.try_emplace(hit.triangle, m_stack, hit.triangle).first;
        const Eigen::Vector3f colour = layers->second.colour({0, 0, 0, hit.barycentric, hit.barycentric});
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = static_cast<std::uint8_t>(std::clamp(colour[channel] + 0.5F, 0.0F, 255.0F));
        pixel[3] = 255;
    }

    const LayerStack& m_stack;
    const PlaneRays& m_rays;
    std::unordered_map<std::uint32_t, TriangleLayers> m_known;
};

} // namespace

/// In place of the texture's patches: a photo beneath is then read as coarsely as the pixels of this picture
/// ask for.
std::vector<Patch> patchesIn(const PhotoPlane& plane, const TriangleMesh& mesh) {
    const Eigen::Matrix4d matrix = photoMatrix(plane.projector, plane.photo);
    const Eigen::Array2d scale(static_cast<double>(plane.picture.width) / plane.photo.width,
                               static_cast<double>(plane.picture.height) / plane.photo.height);
    std::vector<Patch> patches;
    patches.reserve(mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        Patch patch;
        bool isSeen = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector4d seen = matrix * mesh.vertices[triangle[i]].homogeneous();
            isSeen = isSeen && seen.z() > 0;
            patch[i] = (seen.head<2>() / seen.z()).array() * scale;
        }
        if (!isSeen) patch.fill(Eigen::Vector2d::Zero());
        patches.push_back(patch);
    }
    return patches;
}

/// A ray through each pixel finds the surface, and the layers say its colour there: the way back of
/// composing, where each texel looks into the photo. Seen so, a photo and what it is laid on are two pictures
/// of the same plane, which can be compared pixel by pixel.
Image surfaceBeneath(const LayerStack& stack, const SurfaceQuery& query, const PhotoPlane& plane,
                     const Progress& progress) {
    Image picture;
    picture.width = plane.picture.width;
    picture.height = plane.picture.height;
    picture.pixels.resize(4 * static_cast<std::size_t>(picture.width) *
                          static_cast<std::size_t>(picture.height));
    const std::vector<SeenSide> sides = seenSides(stack.surface().mesh, plane.projector);
    const PlaneRays rays(stack.surface().mesh, query, plane, sides);
    const int strips = (picture.height + rowsPerTask - 1) / rowsPerTask;
    forEachInParallel(static_cast<std::size_t>(strips), progress, [&](std::size_t strip) {
        const int row = static_cast<int>(strip) * rowsPerTask;
        SeenRows(stack, rays).fill(row, std::min(row + rowsPerTask, picture.height), picture);
    });
    reportProgress(progress, 1);
    return picture;
}

Image surfaceBeneath(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                     std::array<std::uint8_t, 3> baseColour, const PhotoPlane& plane,
                     const Progress& progress) {
    CompositionCache cache;
    const std::vector<Patch> patches = patchesIn(plane, mesh);
    ProgressParts parts(progress);
    const LayerStack stack(mesh, patches, beneath, baseColour, cache, parts.next(0.5));
    return surfaceBeneath(stack, *cache.queryOf(mesh), plane, parts.rest());
}

} // namespace esm
