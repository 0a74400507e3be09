#include "app/esmc/filling_report.h"

#include "core/solid/prism_wall.h"

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
    const WallFit fit = wallFitOf(network.restPositions, *network.lattice, triangles);
    double volume = 0;
    for (const Tetrahedron& tetrahedron : network.lattice->tetrahedra)
        volume += volumeOf(tetrahedron, network.restPositions);
    report.json["wall"] = {{"volume", volume},
                           {"shortened", fit.thinner},
                           {"least_thickness", fit.least},
                           {"left_out", fit.leftOut}};
    report.text.push_back("wall: " + inText(1e6 * volume) + " ml; thinner than asked for at " +
                          counted(fit.thinner, "vertex", "vertices") + " of " + std::to_string(fit.places) +
                          ", " + inText(1000 * fit.least) + " mm at the least; left out under " +
                          counted(fit.leftOut, "triangle"));
}

std::string thinWallWarning(const SpringNetwork& network, std::size_t triangles) {
    if (!network.lattice || !isWall(network.lattice->filling)) return {};
    const WallFit fit = wallFitOf(network.restPositions, *network.lattice, triangles);
    if (!isOftenThinner(fit)) return {};
    return std::to_string(fit.thinner) + " of " + std::to_string(fit.places) +
           " vertices have a thinner wall than asked for, down to " + inText(1000 * fit.least) + " mm";
}

} // namespace esm
