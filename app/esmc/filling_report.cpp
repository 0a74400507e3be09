#include "app/esmc/filling_report.h"

#include "core/solid/prism_wall.h"

#include <algorithm>

namespace esm {

void addFilling(Json& json, const LatticeFilling& filling) {
    json["lattice"] = wordOf(filling.kind);
    if (isWall(filling)) {
        json["wall_thickness"] = filling.wallThickness;
        json["layers"] = filling.layers;
    } else {
        json["spacing"] = filling.spacing;
    }
}

std::string fillingText(const LatticeFilling& filling) {
    if (isWall(filling))
        return "wall of prisms, " + inText(filling.wallThickness) + " m in " +
               counted(static_cast<std::size_t>(filling.layers), "layer");
    return std::string(wordOf(filling.kind)) + " lattice, spacing " + inText(filling.spacing) + " m";
}

void addCrossings(Report& report, const NarrowCrossings& crossings) {
    report.json["crossings"] = {{"places", crossings.places}, {"width", crossings.width}};
    if (crossings.places == 0) return;
    report.text.push_back("the surface runs through itself at " + counted(crossings.places, "place") + ", " +
                          inText(1000 * crossings.width) +
                          " mm across at most: the lattice passes over that");
}

void addWall(Report& report, const SpringNetwork& network, std::size_t triangles) {
    const LatticeFilling& filling = network.lattice->filling;
    const std::vector<double> thicknesses = wallThicknesses(network.restPositions, filling.layers);
    const auto shortened =
        static_cast<std::size_t>(std::count_if(thicknesses.begin(), thicknesses.end(), [&](double thickness) {
            return thickness < 0.99 * filling.wallThickness;
        }));
    const double least = *std::min_element(thicknesses.begin(), thicknesses.end());
    double volume = 0;
    for (const Tetrahedron& tetrahedron : network.lattice->tetrahedra)
        volume += volumeOf(tetrahedron, network.restPositions);
    const std::size_t prisms =
        network.lattice->tetrahedra.size() / (3 * static_cast<std::size_t>(filling.layers));
    const std::size_t leftOut = triangles - prisms;
    report.json["wall"] = {
        {"volume", volume}, {"shortened", shortened}, {"least_thickness", least}, {"left_out", leftOut}};
    report.text.push_back("wall: " + inText(1e6 * volume) + " ml; thinner than asked for at " +
                          counted(shortened, "vertex", "vertices") + " of " +
                          std::to_string(thicknesses.size()) + ", " + inText(1000 * least) +
                          " mm at the least; left out under " + counted(leftOut, "triangle"));
}

} // namespace esm
