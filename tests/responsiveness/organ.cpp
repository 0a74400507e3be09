#include "tests/responsiveness/organ.h"

#include "core/authoring/packing.h"
#include "core/geometry/repair.h"
#include "core/samples/samples.h"

#include <algorithm>
#include <cmath>

namespace responsiveness {

namespace {

constexpr double radius = 0.06; // m

/// A cube's six faces as nets of squares, drawn to a ball: triangles of nearly one size everywhere. Faces
/// meet in vertices that are given twice, as in files.
esm::PolygonSoup ball(std::size_t nodes) {
    const auto squares = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(nodes) / 6));
    esm::PolygonSoup soup;
    for (int face = 0; face < 6; ++face) {
        const auto first = static_cast<std::uint32_t>(soup.vertices.size());
        const int axis = face / 2;
        const double side = face % 2 ? 1 : -1;
        for (std::uint32_t row = 0; row <= squares; ++row)
            for (std::uint32_t column = 0; column <= squares; ++column) {
                Eigen::Vector3d point;
                point[axis] = side;
                point[(axis + 1) % 3] = side * (2.0 * row / squares - 1);
                point[(axis + 2) % 3] = 2.0 * column / squares - 1;
                soup.vertices.push_back(radius * point.normalized());
            }
        for (std::uint32_t row = 0; row < squares; ++row)
            for (std::uint32_t column = 0; column < squares; ++column) {
                const std::uint32_t corner = first + row * (squares + 1) + column;
                soup.polygons.push_back({corner, corner + squares + 1, corner + squares + 2, corner + 1});
            }
    }
    return soup;
}

} // namespace

esm::Project ballOf(std::size_t nodes, Tissue tissue) {
    esm::Project project = esm::makeProject("ball", esm::repair(ball(nodes), {.weldDistance = 1e-9}));
    esm::Region region = esm::makeSample("liver").regions.front();
    region.id = {1};
    region.ellipsoid = esm::Ellipsoid{{radius, 0, 0}, {radius, radius, radius}};
    region.rim = radius / 4;
    project.regions = {region};
    if (tissue == Tissue::WeaklyDamped) {
        project.base.viscosity = 1e-3;
        project.regions.front().held.viscosity = 1e-3;
        for (esm::TetherRule& rule : project.scene.tethers)
            rule.viscosity = 1e-3;
    }
    return project;
}

esm::Project drawnBallOf(std::size_t triangles, std::size_t nodes) {
    const esm::Detail detail{esm::Detail::Kind::Nodes, nodes};
    return esm::makeProject("ball", esm::repair(ball(triangles / 2), {.weldDistance = 1e-9}), std::nullopt,
                            detail);
}

esm::Project photographedBallOf(std::size_t triangles, int photos, int pageSize) {
    esm::Project project = drawnBallOf(triangles, 1000);
    project.texture.atlas.size = pageSize;
    esm::pack(project);
    for (int i = 0; i <= photos; ++i) {
        esm::TextureLayer layer;
        layer.id = {static_cast<std::uint32_t>(i) + 1};
        layer.name = "layer " + std::to_string(i + 1);
        if (i < photos) layer.photo = esm::makeSamplePhoto(esm::samplePhotoNames().front());
        const Eigen::AngleAxisd turn(2 * M_PI * (i - photos + 1) / photos, Eigen::Vector3d::UnitY());
        layer.projector.pose = turn * Eigen::Translation3d(0, 0, 4 * radius);
        layer.projector.kind = esm::ProjectorKind::Perspective;
        layer.projector.fieldOfView = 25;
        project.layers.push_back(layer);
    }
    esm::TextureLayer& last = project.layers[static_cast<std::size_t>(photos) - 1];
    last.blending = esm::Blending::MultiBand;
    esm::BrushStroke erasing;
    erasing.radius = radius / 6;
    erasing.path = {{{0, 0, radius}, {0, 0, 1}}, {{radius / 4, 0, 0.97 * radius}, {0.25, 0, 1}}};
    last.strokes.push_back(std::make_shared<const esm::BrushStroke>(erasing));
    return project;
}

} // namespace responsiveness
