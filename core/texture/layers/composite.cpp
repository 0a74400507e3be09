#include "core/texture/layers/composite.h"

#include "core/support/errors.h"
#include "core/texture/layers/layer_projection.h"
#include "core/texture/layers/patch_scan.h"
#include "core/texture/texture_limits.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// Bands between two reports of progress.
constexpr std::size_t bandsPerReport = 16;

/// Surface this share of the model's size apart hides nothing: the rays know points only to single precision.
constexpr double hidingTolerance = 1e-4;

/// Half a texel's diagonal: a patch within it touches the texel, even where it is too small to hold any
/// centre.
constexpr double touching = 0.70711;

void checkAtlas(const TriangleMesh& mesh, const Atlas& atlas) {
    const std::vector<std::string> problems = validate(atlas, mesh.triangles.size());
    if (!problems.empty()) throw InvalidModel(problems);
}

/// What all bands share: the shown layers, each photo's pyramid once, and the surface for shadows.
class Painter {
public:
    Painter(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<TextureLayer>& layers)
        : m_atlas(atlas), m_surface{mesh, nullptr,
                                    hidingTolerance * boundingBox(mesh.vertices).diagonal().norm()} {
        checkAtlas(mesh, atlas);
        for (const TextureLayer& layer : layers)
            if (layer.visible && layer.opacity > 0 && !layer.photo->image.empty()) add(layer);
        if (m_query) m_surface.query = &*m_query;
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    bool isEmpty() const { return m_layers.empty(); }

    /// The layers that may reach a triangle, from the lowest to the topmost.
    std::vector<TriangleProjection> projectionsOn(std::uint32_t triangle) const {
        std::vector<TriangleProjection> projections;
        for (const auto& [layer, sampler] : m_layers) {
            auto projection =
                TriangleProjection::make(*layer, *sampler, m_surface, triangle, m_atlas.corners[triangle]);
            if (projection) projections.push_back(*projection);
        }
        return projections;
    }

private:
    void add(const TextureLayer& layer) {
        const Image& picture = *pictureOf(layer); // which the layer keeps
        auto& sampler = m_samplers[&picture];
        if (!sampler) sampler = std::make_unique<PhotoSampler>(picture);
        m_layers.emplace_back(&layer, sampler.get());
        if (layer.projector.occlusion && !m_query)
            m_query.emplace(m_surface.mesh.vertices, m_surface.mesh.triangles);
    }

    const Atlas& m_atlas;
    LitSurface m_surface;
    std::optional<SurfaceQuery> m_query;
    std::map<const Image*, std::unique_ptr<PhotoSampler>> m_samplers;
    std::vector<std::pair<const TextureLayer*, const PhotoSampler*>> m_layers;
};

/// Photos are mixed in sRGB values, as the source does and as picture editors do.
Eigen::Vector3f mixed(Eigen::Vector3f colour, const std::vector<TriangleProjection>& layers,
                      const PatchTexel& texel) {
    for (const TriangleProjection& layer : layers) {
        const Eigen::Vector4f photo = layer.at(texel);
        colour += photo.w() * (photo.head<3>() - colour);
    }
    return colour;
}

void paintBand(const Painter& painter, const Atlas& atlas, const PageBand& band, const Eigen::Vector3f& base,
               Image& page) {
    const double reach = fillReach(atlas.options);
    const BandOwners owners(atlas, band, reach);
    for (const std::uint32_t triangle : band.triangles) {
        const std::vector<TriangleProjection> layers = painter.projectionsOn(triangle);
        if (layers.empty()) continue;
        PatchScan(atlas.corners[triangle])
            .forEachTexel(band, page.width, reach, [&](const PatchTexel& texel) {
                if (owners.at(texel.x, texel.y) != triangle) return;
                const Eigen::Vector3f colour = mixed(base, layers, texel);
                std::uint8_t* pixel = page.at(texel.x, texel.y);
                for (int channel = 0; channel < 3; ++channel)
                    pixel[channel] =
                        static_cast<std::uint8_t>(std::clamp(colour[channel] + 0.5F, 0.0F, 255.0F));
            });
    }
}

Image filledPage(int size, const std::array<std::uint8_t, 3>& colour) {
    Image page;
    page.width = page.height = size;
    page.pixels.resize(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 255);
    for (std::size_t i = 0; i < page.pixels.size(); i += 4)
        std::copy(colour.begin(), colour.end(), &page.pixels[i]);
    return page;
}

} // namespace

std::vector<Image> composite(const TriangleMesh& mesh, const Atlas& atlas,
                             const std::vector<TextureLayer>& layers, std::array<std::uint8_t, 3> baseColour,
                             const Progress& progress) {
    const Painter painter(mesh, atlas, layers);
    std::vector<Image> pages(static_cast<std::size_t>(atlas.options.pages),
                             filledPage(atlas.options.size, baseColour));
    if (painter.isEmpty()) return pages;
    const std::vector<PageBand> bands = pageBands(atlas);
    const Eigen::Vector3f base(baseColour[0], baseColour[1], baseColour[2]);
    for (std::size_t first = 0; first < bands.size(); first += bandsPerReport) {
        reportProgress(progress, static_cast<double>(first) / static_cast<double>(bands.size()));
        tbb::parallel_for(first, std::min(first + bandsPerReport, bands.size()), [&](std::size_t i) {
            paintBand(painter, atlas, bands[i], base, pages[static_cast<std::size_t>(bands[i].page)]);
        });
    }
    reportProgress(progress, 1);
    return pages;
}

LayerCoverage coverage(const TriangleMesh& mesh, const Atlas& atlas, const TextureLayer& layer) {
    const std::vector<TextureLayer> only{layer};
    const Painter painter(mesh, atlas, only);
    const PageBand whole{0, 0, atlas.options.size, {}};
    std::vector<LayerCoverage> covered(mesh.triangles.size());
    tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t i) {
        const auto triangle = static_cast<std::uint32_t>(i);
        const std::vector<TriangleProjection> layers = painter.projectionsOn(triangle);
        if (layers.empty()) return;
        PatchScan(atlas.corners[i])
            .forEachTexel(whole, atlas.options.size, touching, [&](const PatchTexel& texel) {
                if (layers.front().at(texel).w() <= 0) return;
                covered[i].triangles = 1;
                covered[i].texels += texel.distance == 0 ? 1 : 0;
            });
    });
    LayerCoverage sum;
    for (const LayerCoverage& one : covered) {
        sum.texels += one.texels;
        sum.triangles += one.triangles;
    }
    return sum;
}

} // namespace esm
