#pragma once

#include "core/project/project.h"
#include "core/support/json_reader.h"

#include <vector>

/// What the project file and the model package hold alike, besides their regions.
namespace esm {

/// What decides a file's version.
struct VersionNeeds {
    bool binding = false;           ///< a surface that is carried by fewer nodes: version 2
    bool stiffening = false;        ///< biphasic springs: version 3
    bool extendedInference = false; ///< norms, weights, OR or NOT in a fuzzy system: version 4
    bool softRims = false;          ///< regions that fade into what lies beneath: version 5
    bool perspective = false;       ///< photos thrown in perspective or with falloff: version 6
    bool preparation = false;       ///< photos that are prepared: version 7
    bool painting = false;          ///< layers painted or blended otherwise than by hiding: version 8
    bool landmarks = false;         ///< photos with landmarks: version 8
    bool maskedPhotos = false;      ///< photos with strokes, or their colours matched: version 8
};

/// What the regions and their fuzzy systems need, with what else does.
VersionNeeds needsOf(const std::vector<Region>& regions, bool binding, bool stiffening);

/// The oldest that has all of it, so that older programs go on reading all that they understand.
int versionOf(const VersionNeeds& needs);

/// @throws InvalidModel where the file's `version` is a newer one than `known`
void refuseNewerVersion(const JsonReader& file, int known);

nlohmann::ordered_json toJson(const BaseTissue& base);
BaseTissue baseTissueFromJson(const JsonReader& reader);

nlohmann::ordered_json toJson(const SpringStiffening& stiffening);
SpringStiffening stiffeningFromJson(const JsonReader& reader);

nlohmann::ordered_json toJson(const MeasuredStepping& measured);
/// Nothing where the integrator is one that only other programs know.
std::optional<MeasuredStepping> steppingFromJson(const JsonReader& reader);
/// Names the integrator that only other programs know. Precondition: steppingFromJson() found no problem in
/// the holder's `stepping`.
std::vector<std::string> steppingWarnings(const nlohmann::ordered_json& holder);

/// x, y, z of every point in one list, and back.
std::vector<double> coordinatesOf(const std::vector<Eigen::Vector3d>& points);

template<typename Number> std::vector<Eigen::Vector3d> pointsOf(const std::vector<Number>& coordinates) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(coordinates.size() / 3);
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
        points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    return points;
}

/// Three corners per triangle in one list, and back.
std::vector<std::uint32_t> cornersOf(const std::vector<Triangle>& triangles);
std::vector<Triangle> trianglesOf(const std::vector<std::uint32_t>& corners);

/// A binding's vertices and lines as lists: three nodes and three shares per vertex, two nodes per line; and
/// back, as many vertices as both lists give.
struct BindingNumbers {
    std::vector<std::uint32_t> nodes;
    std::vector<double> shares;
    std::vector<std::uint32_t> lines;
};
BindingNumbers numbersOf(const Binding& binding);
Binding bindingOf(const BindingNumbers& numbers, std::vector<Triangle> surface);

} // namespace esm
