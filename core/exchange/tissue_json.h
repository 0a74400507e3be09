#pragma once

#include "core/exchange/fields_json.h"
#include "core/model/stepping.h"
#include "core/model/tissue_model.h"

#include <vector>

/// What of tissue the project file and the model package hold alike.
namespace esm {

/// Integrators by name. One that only other programs know stays as it was: who reads sees to that.
struct SteppingForms {
    nlohmann::ordered_json write(Integrator integrator) const;
    void read(const JsonReader& reader, Integrator& integrator) const;
};

nlohmann::ordered_json toJson(const MeasuredStepping& measured);
/// Nothing where the integrator is one that only other programs know.
std::optional<MeasuredStepping> steppingFromJson(const JsonReader& reader);
/// Names the integrator that only other programs know. Precondition: steppingFromJson() found no problem in
/// the holder's `stepping`.
std::vector<std::string> steppingWarnings(const nlohmann::ordered_json& holder);

/// Time and pressure in a list of two, s and Pa.
nlohmann::ordered_json toJson(const PressurePoint& point);
void fromJson(const JsonReader& reader, PressurePoint& point);

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

/// Four corners per tetrahedron in one list, and back.
std::vector<std::uint32_t> cornersOf(const std::vector<Tetrahedron>& tetrahedra);
std::vector<Tetrahedron> tetrahedraOf(const std::vector<std::uint32_t>& corners);

/// A binding's vertices and lines as lists, two nodes per line.
struct BindingNumbers {
    /// Where each vertex's nodes begin, then where the last one's end. Absent where none has more than three,
    /// as in files of before: each has three then, those not needed with the share 0.
    std::optional<std::vector<std::uint32_t>> starts;
    std::vector<std::uint32_t> nodes;
    std::vector<double> shares;
    std::vector<std::uint32_t> lines;
};
/// Whether a vertex has more than three nodes.
bool needsStarts(const Binding& binding);
/// Precondition: a valid binding.
BindingNumbers numbersOf(const Binding& binding);
/// Without starts as many vertices as both lists give.
Binding bindingOf(const BindingNumbers& numbers, std::vector<Triangle> surface);

} // namespace esm
