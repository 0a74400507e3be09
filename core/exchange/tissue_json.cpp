#include "core/exchange/tissue_json.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

Json toJson(const SpringStiffening& stiffening) {
    return {{"strain", stiffening.strain}, {"factor", stiffening.factor}};
}

SpringStiffening stiffeningFromJson(const JsonReader& reader) {
    return {reader.member("strain").number(), reader.member("factor").number()};
}

Json toJson(const MeasuredStepping& measured) {
    Json json{{"integrator", integratorName(measured.stepping.integrator)},
              {"timeStep", measured.stepping.timeStep},
              {"precision", precisionName(measured.stepping.precision)},
              {"error", measured.error},
              {"wallPerSimulatedSecond", measured.wallPerSimulatedSecond}};
    if (!measured.tissue.empty()) json["tissue"] = measured.tissue;
    return json;
}

std::optional<MeasuredStepping> steppingFromJson(const JsonReader& reader) {
    const auto integrator = integratorFromName(reader.member("integrator").text());
    const JsonReader named = reader.member("precision");
    const auto precision = precisionFromName(named.text());
    if (named.json().is_string() && !precision) named.addProblem("should be double or float");
    const MeasuredStepping measured{{integrator.value_or(Integrator::Auto),
                                     reader.member("timeStep").number(),
                                     precision.value_or(Precision::Double)},
                                    reader.member("error").number(),
                                    reader.member("wallPerSimulatedSecond").number(),
                                    reader.has("tissue") ? reader.member("tissue").text() : std::string()};
    if (!integrator) return std::nullopt;
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
