#include "core/exchange/tissue_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t nodesWithoutStarts = 3; ///< per vertex

/// With the last node again where there are fewer.
void addFilledUp(const VertexBinding& vertex, BindingNumbers& numbers) {
    for (std::size_t place = 0; place < nodesWithoutStarts; ++place) {
        const bool isThere = place < vertex.nodes.size();
        numbers.nodes.push_back(isThere ? vertex.nodes[place] : vertex.nodes.back());
        numbers.shares.push_back(isThere ? vertex.shares[place] : 0);
    }
}

BindingRows rowsOfThree(const std::vector<std::uint32_t>& nodes, const std::vector<double>& shares) {
    const std::size_t count = std::min(nodes.size(), shares.size()) / nodesWithoutStarts;
    BindingRows rows;
    rows.starts.reserve(count + 1);
    for (std::size_t row = 1; row <= count; ++row)
        rows.starts.push_back(static_cast<std::uint32_t>(nodesWithoutStarts * row));
    rows.nodes.assign(nodes.begin(), nodes.begin() + rows.starts.back());
    rows.shares.assign(shares.begin(), shares.begin() + rows.starts.back());
    return rows;
}

} // namespace

Json SteppingForms::write(Integrator integrator) const {
    return integratorName(integrator);
}

void SteppingForms::read(const JsonReader& reader, Integrator& integrator) const {
    integrator = integratorFromName(reader.text()).value_or(integrator);
}

Json toJson(const MeasuredStepping& measured) {
    return writtenFields(measured, SteppingForms());
}

std::optional<MeasuredStepping> steppingFromJson(const JsonReader& reader) {
    MeasuredStepping measured;
    readFields(reader, measured, SteppingForms());
    const Json& integrator = reader.member("integrator").json();
    if (!integrator.is_string() || !integratorFromName(integrator.get<std::string>())) return std::nullopt;
    return measured;
}

std::vector<std::string> steppingWarnings(const Json& holder) {
    const auto stepping = holder.find("stepping");
    if (stepping == holder.end() || stepping->is_null()) return {};
    const std::string name = (*stepping)["integrator"].get<std::string>();
    if (integratorFromName(name)) return {};
    return {"the recommended stepping names the integrator \"" + name +
            "\", which this program does not know: it is left out; measure the tissue anew (esmc tradeoff)"};
}

Json toJson(const PressurePoint& point) {
    return {point.time, point.pressure};
}

void fromJson(const JsonReader& reader, PressurePoint& point) {
    const std::vector<double> row = reader.numbers(2);
    point = {row[0], row[1]};
}

std::vector<double> coordinatesOf(const std::vector<Eigen::Vector3d>& points) {
    std::vector<double> values;
    values.reserve(3 * points.size());
    for (const Eigen::Vector3d& point : points)
        values.insert(values.end(), point.data(), point.data() + 3);
    return values;
}

std::vector<std::uint32_t> cornersOf(const std::vector<Triangle>& triangles) {
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * triangles.size());
    for (const Triangle& triangle : triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    return corners;
}

std::vector<Triangle> trianglesOf(const std::vector<std::uint32_t>& corners) {
    std::vector<Triangle> triangles;
    triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); i += 3)
        triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return triangles;
}

std::vector<std::uint32_t> cornersOf(const std::vector<Tetrahedron>& tetrahedra) {
    std::vector<std::uint32_t> corners;
    corners.reserve(4 * tetrahedra.size());
    for (const Tetrahedron& tetrahedron : tetrahedra)
        corners.insert(corners.end(), tetrahedron.begin(), tetrahedron.end());
    return corners;
}

std::vector<Tetrahedron> tetrahedraOf(const std::vector<std::uint32_t>& corners) {
    std::vector<Tetrahedron> tetrahedra;
    tetrahedra.reserve(corners.size() / 4);
    for (std::size_t i = 0; i < corners.size(); i += 4)
        tetrahedra.push_back({corners[i], corners[i + 1], corners[i + 2], corners[i + 3]});
    return tetrahedra;
}

bool needsStarts(const Binding& binding) {
    const std::vector<std::uint32_t>& starts = binding.vertices.starts;
    return std::adjacent_find(starts.begin(), starts.end(), [](std::uint32_t start, std::uint32_t next) {
               return next - start > nodesWithoutStarts;
           }) != starts.end();
}

BindingNumbers numbersOf(const Binding& binding) {
    const BindingRows& rows = binding.vertices;
    BindingNumbers numbers;
    if (needsStarts(binding))
        numbers = {rows.starts, rows.nodes, rows.shares, {}};
    else
        for (std::size_t i = 0; i < rows.size(); ++i)
            addFilledUp(rows[i], numbers);
    for (const Edge& line : binding.lines)
        numbers.lines.insert(numbers.lines.end(), {line.first, line.second});
    return numbers;
}

Binding bindingOf(const BindingNumbers& numbers, std::vector<Triangle> surface) {
    Binding binding{std::move(surface), {}, {}};
    binding.vertices = numbers.starts ? BindingRows{*numbers.starts, numbers.nodes, numbers.shares}
                                      : rowsOfThree(numbers.nodes, numbers.shares);
    for (std::size_t i = 0; i + 1 < numbers.lines.size(); i += 2)
        binding.lines.emplace_back(numbers.lines[i], numbers.lines[i + 1]);
    return binding;
}

} // namespace esm
