#include "core/render/colouring.h"

#include "core/project/project.h"
#include "core/render/colour_ramp.h"
#include "core/render/drawn_shape.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;

struct ColouringRow {
    ColourBy by;
    const char *name, *title, *unit;
    double perUnit; ///< SI units in one of the legend's
    bool isOfMotion;
};

const ColouringRow& rowOf(ColourBy by) {
    static constexpr std::array<ColouringRow, everyColouring.size()> rows{
        {{ColourBy::Texture, "texture", "Spring constant", "N/m", 1, false},
         {ColourBy::SpringConstant, "spring-constant", "Spring constant", "N/m", 1, false},
         {ColourBy::Viscosity, "viscosity", "Viscosity", "N·s/m", 1, false},
         {ColourBy::Mass, "mass", "Mass of a node", "g", 1e-3, false},
         {ColourBy::Strain, "strain", "Strain of springs", "%", 0.01, true},
         {ColourBy::Speed, "speed", "Speed", "mm/s", 1e-3, true},
         {ColourBy::Region, "region", "Region", "", 1, false}}};
    return rows[static_cast<std::size_t>(by)];
}

/// SI; either list may be empty.
struct ShownValues {
    std::vector<double> springs, nodes;
};

double meanOfEnds(const std::vector<double>& nodes, const Spring& spring) {
    return (nodes[spring.first] + nodes[spring.second]) / 2;
}

std::vector<double> meansOfEnds(const SpringNetwork& network, const std::vector<double>& nodes) {
    std::vector<double> springs;
    springs.reserve(network.springs.size());
    for (const Spring& spring : network.springs)
        springs.push_back(meanOfEnds(nodes, spring));
    return springs;
}

/// A node's own value says nothing where springs have values of their own: their mean does.
std::vector<double> meansAtNodes(const SpringNetwork& network, const std::vector<double>& springs) {
    std::vector<double> sums(network.restPositions.size(), 0), counts(sums.size(), 0);
    for (std::size_t i = 0; i < network.springs.size(); ++i)
        for (const std::uint32_t node : {network.springs[i].first, network.springs[i].second}) {
            sums[node] += springs[i];
            ++counts[node];
        }
    for (std::size_t node = 0; node < sums.size(); ++node)
        if (counts[node] > 0) sums[node] /= counts[node];
    return sums;
}

ShownValues tissueValues(const TissueModel& tissue, double SpringValues::*value,
                         const std::vector<double>& ofNodes) {
    // How tissue is shared out is the mesh's affair: what regions say of it is shown.
    const bool isShared = tissue.network->sheet || tissue.network->lattice;
    if (isShared || tissue.ownValues.empty()) return {meansOfEnds(*tissue.network, ofNodes), ofNodes};
    ShownValues shown;
    for (const SpringValues& spring : springValues(tissue))
        shown.springs.push_back(spring.*value);
    shown.nodes = meansAtNodes(*tissue.network, shown.springs);
    return shown;
}

/// Lengthening or shortening, as a part of the length at rest. A spring without such a length has none.
ShownValues strains(const SpringNetwork& network, const std::vector<Vector3d>& positions) {
    ShownValues shown;
    shown.nodes.assign(positions.size(), 0);
    shown.springs.reserve(network.springs.size());
    for (const auto& [first, second, rest] : network.springs) {
        const double strain =
            rest > 0 ? std::abs((positions[first] - positions[second]).norm() - rest) / rest : 0;
        shown.springs.push_back(strain);
        for (const std::uint32_t node : {first, second})
            shown.nodes[node] = std::max(shown.nodes[node], strain);
    }
    return shown;
}

ShownValues valuesOf(const RenderScene& scene, ColourBy by, const ColourSources& from) {
    const SpringNetwork& network = *from.tissue.network;
    switch (by) {
    case ColourBy::Viscosity:
        return tissueValues(from.tissue, &SpringValues::viscosity, from.tissue.viscosity);
    case ColourBy::Mass:
        return {meansOfEnds(network, from.tissue.mass), from.tissue.mass};
    case ColourBy::Strain:
        return strains(network, drawnNodes(scene));
    case ColourBy::Speed:
        if (from.speeds.size() != network.restPositions.size()) return {};
        return {meansOfEnds(network, from.speeds), from.speeds};
    default:
        return tissueValues(from.tissue, &SpringValues::springConstant, from.tissue.springConstant);
    }
}

std::optional<ValueRange> extremes(const ShownValues& values) {
    std::optional<ValueRange> range;
    for (const std::vector<double>* list : {&values.springs, &values.nodes})
        for (const double value : *list) {
            if (!std::isfinite(value)) continue;
            if (!range) range = {value, value};
            range = {std::min(range->minimum, value), std::max(range->maximum, value)};
        }
    return range;
}

/// The least of 1, 2 and 5 times a power of ten that is not less.
double roundedUp(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= value * (1 - 1e-9)) return step * power;
    return 10 * power;
}

/// In SI. Small motion is told from none by the least range, a unit of the legend.
ValueRange motionRange(const ValueRange& present, const std::optional<ValueRange>& before, double least) {
    return {0, std::max({roundedUp(std::max(present.maximum, least)), before ? before->maximum : 0, least})};
}

/// The ramp in so many steps that none is seen, so that a frame of many springs costs little.
Paint paintOf(double value, const ValueRange& range) {
    static const std::array<Paint, 512> table = [] {
        std::array<Paint, 512> steps{};
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const Colour colour = rampColour(double(i) / double(steps.size() - 1));
            steps[i] = {colour[0], colour[1], colour[2], 255};
        }
        return steps;
    }();
    if (!std::isfinite(value)) return {};
    const double width = range.maximum - range.minimum;
    // One value everywhere has the middle's colour: it is neither small nor large.
    const double share = width > 0 ? std::clamp((value - range.minimum) / width, 0.0, 1.0) : 0.5;
    return table[static_cast<std::size_t>(std::lround(share * double(table.size() - 1)))];
}

std::shared_ptr<const std::vector<Paint>> painted(const std::vector<double>& values,
                                                  const ValueRange& range) {
    auto paint = std::make_shared<std::vector<Paint>>();
    paint->reserve(values.size());
    for (const double value : values)
        paint->push_back(paintOf(value, range));
    return paint;
}

/// Laid one over the other from the first to the last, each as far as its weight, as their tissue is.
std::vector<Paint> regionPaint(const SpringNetwork& network, const std::vector<Region>& regions) {
    std::vector<Eigen::Vector4d> mixed(network.restPositions.size(), Eigen::Vector4d::Zero());
    for (const Region& region : regions) {
        const Eigen::Vector4d paint(region.colour[0], region.colour[1], region.colour[2], 255);
        for (std::size_t node = 0; node < mixed.size(); ++node) {
            const double weight = weightAt(region, network.restPositions[node]);
            const double left = (1 - weight) * mixed[node][3] / 255; // of what lies beneath
            if (!(weight + left > 0)) continue;
            mixed[node].head<3>() =
                (weight * paint.head<3>() + left * mixed[node].head<3>()) / (weight + left);
            mixed[node][3] = 255 * (weight + left);
        }
    }
    std::vector<Paint> nodes;
    nodes.reserve(mixed.size());
    for (const Eigen::Vector4d& paint : mixed)
        nodes.push_back({static_cast<std::uint8_t>(std::lround(paint[0])),
                         static_cast<std::uint8_t>(std::lround(paint[1])),
                         static_cast<std::uint8_t>(std::lround(paint[2])),
                         static_cast<std::uint8_t>(std::lround(paint[3]))});
    return nodes;
}

/// A spring belongs to a region as far as the end does that belongs less.
std::optional<ColourLegend> colourByRegion(RenderScene& scene, const ColourSources& from) {
    const SpringNetwork& network = *from.tissue.network;
    const std::vector<Paint> nodes = regionPaint(network, from.regions);
    auto springs = std::make_shared<std::vector<Paint>>();
    springs->reserve(network.springs.size());
    for (const Spring& spring : network.springs)
        springs->push_back(nodes[spring.first][3] < nodes[spring.second][3] ? nodes[spring.first]
                                                                            : nodes[spring.second]);
    scene.nodePaint = std::make_shared<const std::vector<Paint>>(nodes);
    scene.springPaint = springs;
    ColourLegend legend{rowOf(ColourBy::Region).title, "", {}, {}};
    for (auto region = from.regions.rbegin(); region != from.regions.rend(); ++region)
        legend.entries.push_back({region->name, region->colour});
    return legend;
}

} // namespace

std::string nameOf(ColourBy by) {
    return rowOf(by).name;
}

std::optional<ColourBy> colourByFromName(std::string_view name) {
    for (const ColourBy by : everyColouring)
        if (rowOf(by).name == name) return by;
    return std::nullopt;
}

bool followsMotion(ColourBy by) {
    return rowOf(by).isOfMotion;
}

std::optional<ColourLegend> colourScene(RenderScene& scene, ColourBy by, const ColourSources& from,
                                        std::optional<ValueRange>& range) {
    const std::optional<ValueRange> before = std::exchange(range, std::nullopt);
    scene.nodePaint.reset();
    scene.springPaint.reset();
    if (by == ColourBy::Region) return colourByRegion(scene, from);
    const ShownValues values = valuesOf(scene, by, from);
    range = extremes(values);
    if (!range) return std::nullopt;
    const ColouringRow& row = rowOf(by);
    if (row.isOfMotion) range = motionRange(*range, before, row.perUnit);
    scene.springPaint = painted(values.springs, *range);
    if (by != ColourBy::Texture) scene.nodePaint = painted(values.nodes, *range);
    return ColourLegend{
        row.title, row.unit, {range->minimum / row.perUnit, range->maximum / row.perUnit}, {}};
}

} // namespace esm
