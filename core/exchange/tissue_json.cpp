#include "core/exchange/tissue_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

struct SteppingForms {
    Json write(Integrator integrator) const { return integratorName(integrator); }
    /// One that only other programs know stays as it was: steppingFromJson() sees to that.
    void read(const JsonReader& reader, Integrator& integrator) const {
        integrator = integratorFromName(reader.text()).value_or(integrator);
    }
};

} // namespace

Json toJson(const MeasuredStepping& measured) {
    Json json = writtenFields(measured.stepping, SteppingForms());
    json.update(writtenFields(measured));
    return json;
}

std::optional<MeasuredStepping> steppingFromJson(const JsonReader& reader) {
    MeasuredStepping measured;
    readFields(reader, measured.stepping, SteppingForms());
    readFields(reader, measured);
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

BindingNumbers numbersOf(const Binding& binding) {
    BindingNumbers numbers;
    for (const VertexBinding& vertex : binding.vertices) {
        numbers.nodes.insert(numbers.nodes.end(), vertex.nodes.begin(), vertex.nodes.end());
        numbers.shares.insert(numbers.shares.end(), vertex.shares.data(), vertex.shares.data() + 3);
    }
    for (const Edge& line : binding.lines)
        numbers.lines.insert(numbers.lines.end(), {line.first, line.second});
    return numbers;
}

Binding bindingOf(const BindingNumbers& numbers, std::vector<Triangle> surface) {
    Binding binding{std::move(surface), {}, {}};
    const std::vector<Triangle> nodes = trianglesOf(numbers.nodes);
    const std::vector<Eigen::Vector3d> shares = pointsOf(numbers.shares);
    for (std::size_t i = 0; i < std::min(nodes.size(), shares.size()); ++i)
        binding.vertices.push_back({nodes[i], shares[i]});
    for (std::size_t i = 0; i + 1 < numbers.lines.size(); i += 2)
        binding.lines.emplace_back(numbers.lines[i], numbers.lines[i + 1]);
    return binding;
}

} // namespace esm
