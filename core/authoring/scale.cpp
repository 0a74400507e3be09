#include "core/authoring/scale.h"

#include "core/model/tissue_digest.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

using Points = std::vector<Eigen::Vector3d>;

Points scaled(Points points, double factor) {
    for (Eigen::Vector3d& point : points)
        point *= factor;
    return points;
}

std::shared_ptr<const TriangleMesh> scaled(const TriangleMesh& mesh, double factor) {
    return std::make_shared<const TriangleMesh>(
        TriangleMesh{scaled(mesh.vertices, factor), mesh.triangles, mesh.textureCoordinates});
}

void scale(LatticeFilling& filling, double factor) {
    filling.spacing *= factor;
    filling.wallThickness *= factor;
}

/// A binding's shares and turns do not depend on size, nor do a lattice's. Rest lengths are scaled on their
/// own, not taken anew from the places: a network may have been drawn with tension.
std::shared_ptr<const SpringNetwork> scaled(const SpringNetwork& network, double factor) {
    auto result = std::make_shared<SpringNetwork>(network);
    result->restPositions = scaled(network.restPositions, factor);
    for (Spring& spring : result->springs)
        spring.restLength *= factor;
    if (result->lattice) scale(result->lattice->filling, factor);
    return result;
}

void scale(std::optional<Ellipsoid>& ellipsoid, double factor) {
    if (!ellipsoid) return;
    ellipsoid->centre *= factor;
    ellipsoid->radii *= factor;
}

void scale(Path& path, double factor) {
    for (PathPoint& point : path)
        point.value *= factor;
}

void scale(Scene& scene, double factor) {
    for (NodeSelection& selection : scene.fixed)
        scale(selection.ellipsoid, factor);
    for (NodeMove& move : scene.moves)
        scale(move.path, factor);
    for (InstrumentMotion& instrument : scene.instruments) {
        instrument.shape = scaled(instrument.shape, factor);
        scale(instrument.path, factor);
    }
}

std::shared_ptr<const BrushStroke> scaled(BrushStroke stroke, double factor) {
    stroke.radius *= factor;
    stroke.shift *= factor;
    for (BrushPoint& point : stroke.path)
        point.place *= factor;
    return std::make_shared<const BrushStroke>(std::move(stroke));
}

void scale(TextureLayer& layer, double factor) {
    layer.projector.pose.translation() *= factor;
    layer.projector.width *= factor;
    layer.projector.height *= factor;
    // No file holds a deeper one.
    if (layer.finish) layer.finish->relief = std::min(layer.finish->relief * factor, deepestRelief);
    for (auto& stroke : layer.strokes)
        stroke = scaled(*stroke, factor);
    for (LandmarkPair& pair : layer.landmarks)
        pair.organ *= factor;
}

/// The same texels lie on more or fewer metres.
std::shared_ptr<const Atlas> scaled(const Atlas& atlas, double factor) {
    auto result = std::make_shared<Atlas>(atlas);
    result->texelsPerMetre /= factor;
    result->options.texelsPerMetre /= factor;
    return result;
}

/// Of a filled organ, whose lattice is known by its spacing, its wall by its thickness.
ByValue<MeasuredAccuracy> scaled(MeasuredAccuracy accuracy, double factor) {
    scale(*accuracy.detail.filling, factor);
    return std::make_shared<const MeasuredAccuracy>(std::move(accuracy));
}

void growMasses(Project& project, double factor) {
    const double cube = factor * factor * factor;
    project.base.mass *= cube;
    for (Region& region : project.regions)
        if (region.held.mass) *region.held.mass *= cube;
}

} // namespace

// Lengths are scaled one by one rather than the numbers of the tissue, since what the organ is made of does
// not change with its unit. A measured stepping that names no tissue gets the digest of the tissue before: it
// would else pass for measured on the scaled one, whose rest lengths are others.
Project scaled(const Project& project, double factor, KeptByScaling kept) {
    if (!isPositive(factor)) throw InvalidModel("an organ can only be scaled by a factor above 0");
    Project result = project;
    if (result.stepping && result.stepping->tissue.empty())
        result.stepping->tissue = tissueDigest(evaluateModel(project));
    result.mesh = scaled(*project.mesh, factor);
    result.network = scaled(*project.network, factor);
    if (result.accuracy && result.accuracy->detail.filling)
        result.accuracy = scaled(*project.accuracy, factor);
    for (Region& region : result.regions) {
        scale(region.ellipsoid, factor);
        region.rim *= factor;
    }
    // The thickness of the wall stays: what somebody knows of it in mm, whatever the mesh's unit was taken
    // for.
    scale(result.scene, factor);
    for (TextureLayer& layer : result.layers)
        scale(layer, factor);
    result.texture.atlas.texelsPerMetre /= factor;
    result.texture.occlusionReach = std::min(result.texture.occlusionReach * factor, farthestOcclusion);
    if (result.atlas) result.atlas = scaled(*project.atlas, factor);
    if (kept == KeptByScaling::Density) growMasses(result, factor);
    if (auto problems = validate(result); !problems.empty()) throw InvalidModel(std::move(problems));
    return result;
}

double scaleFactor(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double trueLength) {
    const double distance = (to - from).norm();
    if (!isPositive(distance)) throw InvalidModel("the two points are one; choose two apart");
    if (!isPositive(trueLength)) throw InvalidModel("the true length must be above 0");
    return trueLength / distance;
}

} // namespace esm
