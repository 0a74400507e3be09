#include "tests/support/exchange_projects.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/exchange/image_file.h"
#include "core/project/detail_change.h"
#include "core/project/simulated_network.h"
#include "core/solid/filled_body.h"
#include "tests/support/test_meshes.h"

namespace esm {

std::shared_ptr<const Photo> gradientPhoto(const std::string& fileName, int size) {
    Image image{
        size, size,
        std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size))};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            std::uint8_t* pixel = image.at(x, y);
            pixel[0] = static_cast<std::uint8_t>(255 * x / size);
            pixel[1] = static_cast<std::uint8_t>(255 * y / size);
            pixel[2] = static_cast<std::uint8_t>(fileName.size());
            pixel[3] = x == 0 || y == 0 ? 0 : 255;
        }
    return decodePhoto(fileName, encodePng(image));
}

namespace {

std::shared_ptr<const FuzzySystem> softness() {
    FuzzySystem system;
    system.name = "softness";
    system.note = "for tests; a third is 1/3, \"quoted\"";
    system.inputs = {{"zeal", 0, 1, {{"low", {0, 0, 1.0 / 3, 2.0 / 3}}, {"high", {1.0 / 3, 2.0 / 3, 1, 1}}}},
                     {"age", 0, 100, {{"any", {0, 0, 100, 100}}}}};
    system.outputs = {{"viscosity", 0, 2, {{"thin", {0, 0, 0.5, 1}}, {"thick", {0.5, 1, 2, 2}}}},
                      {"spring_const", 0, 70, {{"soft", {0, 0, 10, 20}}, {"hard", {10, 20, 70, 70}}}}};
    system.rules = {{{{0, 0}}, {{0, 1}, {1, 0}}}, {conjunction({{{0, 1}}, {{1, 0}}}), {{0, 0}, {1, 1}}}};
    return std::make_shared<FuzzySystem>(system);
}

std::vector<Region> someRegions() {
    const auto shared = softness();
    Region whole, part, held;
    whole.name = "Rind, „außen\"";
    whole.system = shared;
    whole.inputs = {{"zeal", 0.1 + 0.2}};
    part.name = "part";
    part.colour = {1, 0, 255};
    part.ellipsoid =
        Ellipsoid{{0.01, 0.02, 1e-17},
                  {0.03, 0.04, 1.0 / 30},
                  Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()))};
    part.system = shared;
    part.inputs = {{"age", 33}, {"zeal", 2.0 / 3}};
    part.held.viscosity = 0.7;
    held.name = "";
    held.ellipsoid = Ellipsoid{{0, 0.05, 0}, {0.02, 0.02, 0.02}, Eigen::Quaterniond::Identity()};
    held.held = {12.34, std::nullopt, 0.0123};
    return {whole, part, held};
}

Scene fullScene() {
    Scene scene;
    scene.duration = 1.1;
    scene.gravity = {-0.0, -9.81, 1e-300};
    scene.fixed = {
        {{2, 1}, std::nullopt},
        {{},
         Ellipsoid{{0, -0.05, 0},
                   {0.01, 0.01, 0.01},
                   Eigen::Quaterniond(Eigen::AngleAxisd(1, Eigen::Vector3d(3, 1, 2).normalized()))}}};
    scene.tethers = {{3, 2.4, 10.7}, {7, 0.1, 0}};
    scene.forces = {{4, {0.1, 0, -1.0 / 3}, 0, 0.5}};
    scene.moves = {{5, {{0, {0, 0, 0}}, {0.7, {0.001, -0.01, 1.0 / 700}}}}};
    scene.instruments = {{Sphere{0.003}, {{0, {0, 0, 0.1}}, {1, {0, 0, 0.05}}}, {}, {}}};
    scene.record = {0.02, std::vector<std::uint32_t>{0, 4, 5}};
    return scene;
}

std::vector<TextureLayer> someLayers() {
    const auto first = gradientPhoto("bild eins.PNG", 40), second = gradientPhoto("b", 16);
    TextureLayer below, above, again;
    below.name = "below";
    below.photo = first;
    below.projector.pose =
        Eigen::Translation3d(0.001, 0, 0.2) * Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX());
    below.projector.width = 0.07;
    below.blendPixels = 3.7;
    above.name = "above";
    above.photo = second;
    above.projector.pose = Eigen::Translation3d(0, 0, 0.1) * Eigen::Quaterniond::Identity();
    above.projector.occlusion = false;
    above.opacity = 1.0 / 3;
    again = below;
    again.name = "again";
    again.visible = false;
    return {below, above, again};
}

/// With a run of each kind: exact enough, on fewer nodes, and one that did not end.
std::shared_ptr<const MeasuredAccuracy> someAccuracy(const Scene& scene) {
    MeasuredAccuracy accuracy;
    accuracy.organ = {"fedcba9876543210", scene};
    accuracy.detail = {Detail::Kind::EveryVertex, 48};
    accuracy.onFewerNodes = MeasuredOrgan{"00112233445566ff", Scene{}};
    accuracy.reference = {{Integrator::Split2, 1e-5 / 3, Precision::Double}, 1e-9 / 7, true};
    accuracy.runs = {{{Integrator::Euler, 1e-4 / 3, Precision::Float}, 48, true, 0.1 / 3, true, 1.0 / 7, {}},
                     {{Integrator::Bdf2, 0.01 / 3, Precision::Double},
                      12,
                      true,
                      0.7,
                      false,
                      1e-3 / 7,
                      Detail{Detail::Kind::Nodes, 12}},
                     {{Integrator::Verlet, 1.0 / 3, Precision::Double}, 48, false, 0, false, 0, {}}};
    accuracy.leftOut = {{{Integrator::Rk4, 1e-7 / 3, Precision::Double},
                         48,
                         "would take 9 s, more than the 1 s that it may"}};
    return std::make_shared<const MeasuredAccuracy>(accuracy);
}

} // namespace

Project richProject(std::uint32_t rings) {
    Project project;
    project.name = "Prüfling \"7\"";
    project.mesh = std::make_shared<TriangleMesh>(test::torus(rings, 6, 0.05, 0.02));
    RepairReport report;
    report.mergedVertices = 11;
    report.flippedTriangles = 5;
    report.components = 1;
    report.nonManifoldEdgesBefore = 2;
    report.warnings = {"merged 11 vertices", "turned 5 triangles"};
    project.importReport = std::make_shared<RepairReport>(report);
    project.network = std::make_shared<SpringNetwork>(networkFromMesh(*project.mesh));
    project.base = {20.1, 0.3, 0.21};
    project.regions = someRegions();
    project.scene = fullScene();
    project.stepping = MeasuredStepping{
        {Integrator::Rk4, 0.1 / 3, Precision::Float}, 1.0 / 7, 1e-300 / 3, "0123456789abcdef"};
    project.accuracy = someAccuracy(project.scene);
    project.layers = someLayers();
    project.texture.atlas = {128, 1, 1};
    project.texture.baseColour = {9, 200, 31};
    project.atlas = std::make_shared<Atlas>(packAtlas(*project.mesh, project.texture.atlas));
    return project;
}

Project boundProject(const Detail& detail) {
    Project project = richProject();
    project.network = std::make_shared<SpringNetwork>(networkOf(*project.mesh, detail));
    return project;
}

// A corner that has the least coordinate along an axis has what its node's share falls by along it. Corners
// without a share are left out, so that rows are of different lengths.
Project filledProject() {
    Project project = richProject();
    project.layers.clear();
    project.atlas = nullptr;
    return withDetail(project,
                      {Detail::Kind::Filled, 0, fillingOf(*project.mesh, LatticeKind::BodyCentred, 60)});
}

Project clinicalProject() {
    Project project = richProject();
    project.layers.clear();
    project.atlas = nullptr;
    project.base.wallThickness = 0.0137 / 3;
    Region region;
    region.name = "stiff";
    region.system = std::make_shared<const FuzzySystem>(fuzzyPreset("organ"));
    region.inputs = {{"firmness", 10.0 / 3}, {"springiness", 7}};
    project.regions = {region};
    return project;
}

Project sheetProject() {
    Project project = richProject();
    project.layers.clear();
    project.atlas = nullptr;
    return withDetail(project, {Detail::Kind::EveryVertex, 0, {}, true});
}

Project latticeProject() {
    Project project = richProject();
    const Eigen::AlignedBox3d box = boundingBox(project.mesh->vertices);
    const auto corner = [&](unsigned node) {
        return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(node));
    };
    SpringNetwork network;
    for (std::uint32_t node = 0; node < 8; ++node) {
        network.restPositions.push_back(corner(node));
        for (std::uint32_t other = 0; other < node; ++other)
            network.springs.push_back({other, node, (corner(node) - corner(other)).norm()});
    }
    network.binding.emplace();
    for (const Eigen::Vector3d& vertex : project.mesh->vertices) {
        const Eigen::Array3d along = (vertex - box.min()).array() / box.sizes().array();
        std::vector<std::uint32_t> nodes;
        std::vector<double> shares;
        for (std::uint32_t node = 0; node < 8; ++node) {
            double share = 1;
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                share *= (node >> axis & 1U) != 0 ? along[axis] : 1 - along[axis];
            if (!(share > 0)) continue;
            nodes.push_back(node);
            shares.push_back(share);
        }
        network.binding->vertices.add({nodes, shares});
    }
    network.vertexNodes = mainNodes(*network.binding);
    project.network = std::make_shared<SpringNetwork>(std::move(network));
    return project;
}

Project rowsProject(std::size_t length) {
    Project project = boundProject({Detail::Kind::Nodes, 20});
    SpringNetwork network = *project.network;
    network.binding->vertices = {};
    for (std::size_t vertex = 0; vertex < project.mesh->vertices.size(); ++vertex) {
        std::vector<std::uint32_t> nodes;
        std::vector<double> shares;
        for (std::size_t place = 0; place < length; ++place) {
            nodes.push_back(static_cast<std::uint32_t>((7 * vertex + place) % network.restPositions.size()));
            shares.push_back(double(2 * place + 1) / double(length * length));
        }
        network.binding->vertices.add({nodes, shares});
    }
    network.vertexNodes = mainNodes(*network.binding);
    project.network = std::make_shared<SpringNetwork>(std::move(network));
    return project;
}

Project biphasicProject() {
    Project project = richProject();
    project.base.stiffening = SpringStiffening{0.1 + 0.2, 1e3 / 7};
    return project;
}

Project extendedInferenceProject() {
    Project project = richProject();
    FuzzySystem system = *softness();
    system.norms = {TNorm::Product, TConorm::BoundedSum, TNorm::BoundedDifference, TConorm::ProbabilisticSum};
    system.rules[0].weight = 1.0 / 3;
    system.rules[1].condition = disjunction({negation({{0, 0}}), system.rules[1].condition});
    for (Region& region : project.regions)
        if (region.system) region.system = std::make_shared<FuzzySystem>(system);
    return project;
}

Project softProject() {
    Project project = richProject();
    project.regions[1].rim = 0.01 / 3;
    return project;
}

// Squares lie in rows around the ring; the last of a row, and the last row, end where the first begin.
Project ownLayoutProject() {
    constexpr std::uint32_t rings = 8, segments = 6;
    Project project = richProject(rings);
    auto mesh = std::make_shared<TriangleMesh>(*project.mesh);
    for (std::uint32_t i = 0; i < mesh->triangles.size(); ++i) {
        CornerCoordinates& places = mesh->textureCoordinates.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            std::uint32_t ring = mesh->triangles[i][corner] / segments,
                          segment = mesh->triangles[i][corner] % segments;
            if (ring == 0 && i / 2 / segments == rings - 1) ring = rings;
            if (segment == 0 && i / 2 % segments == segments - 1) segment = segments;
            places[corner] = {ring / static_cast<double>(rings), segment / static_cast<double>(segments)};
        }
    }
    project.mesh = mesh;
    project.texture.atlas = {128, 1, 1, AtlasLayout::Own};
    project.atlas = std::make_shared<Atlas>(packAtlas(*mesh, project.texture.atlas));
    return project;
}

Project paintedProject() {
    Project project = richProject();
    const auto stroke = [](BrushKind kind) {
        BrushStroke made;
        made.kind = kind;
        made.radius = 0.01 / 3;
        made.softness = 1.0 / 7;
        made.strength = 0.1 + 0.2;
        made.path = {{{0.05, 1.0 / 30, 0}, {0, 0, 1}}, {{0.06, 0, -0.0}, {1e-9, 1, 1.0 / 3}}};
        if (kind == BrushKind::Colour) made.colour = {9, 255, 0};
        if (kind == BrushKind::Clone) made.shift = {0.01, -1.0 / 70, 1e-300};
        return std::make_shared<const BrushStroke>(made);
    };
    project.layers[0].blending = Blending::Multiply;
    project.layers[0].strokes = {stroke(BrushKind::Erase), stroke(BrushKind::Restore)};
    project.layers[1].blending = Blending::MultiBand;
    TextureLayer painted;
    painted.name = "painted";
    painted.blending = Blending::Multiply;
    painted.strokes = {stroke(BrushKind::Colour), stroke(BrushKind::Clone), stroke(BrushKind::Erase)};
    project.layers.push_back(painted);
    return project;
}

Project bareProject() {
    Project project;
    project.name = "motion model";
    project.mesh = std::make_shared<TriangleMesh>();
    project.importReport = std::make_shared<RepairReport>();
    SpringNetwork network;
    for (int i = 0; i < 8; ++i)
        network.restPositions.emplace_back(0.01 * i, 0, 0);
    for (std::uint32_t i = 0; i < 7; ++i)
        network.springs.push_back({i, i + 1, i == 3 ? 0 : 0.01});
    project.network = std::make_shared<SpringNetwork>(network);
    project.base = {5, 0.1, 0.5};
    project.scene.fixed = {{{0, 1, 2, 3, 4, 5}, std::nullopt}};
    return project;
}

Project shiningProject() {
    Project project = richProject();
    project.texture.finish = SurfaceFinish{1.0 / 3, 0.75};
    project.layers[0].finish = LayerFinish{{0.3, 2.0 / 3}, 0.8, 0.01 / 3, false};
    project.layers[1].finish = LayerFinish{{0.95, 0}, 0, 0, true};
    return project;
}

} // namespace esm
