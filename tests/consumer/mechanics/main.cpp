#include "core/dynamics/simulation.h"
#include "core/exchange/package/packaged_tissue.h"

#include <iostream>

/// Loads the package named first, runs it for ten steps and prints its number of nodes and triangles.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 2) return 2;
    const esm::PackagedTissue package = esm::loadPackagedTissue(arguments[1]);
    esm::Simulation simulation(package.tissue, esm::SimulationSettings{});
    for (int i = 0; i < 10; ++i)
        if (!simulation.step(esm::Loads{})) return 1;
    std::cout << simulation.positions().size() << " nodes, " << package.mesh.triangles.size()
              << " triangles\n";
}
