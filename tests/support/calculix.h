#pragma once

#include "tests/support/temporary_folder.h"

#include <Eigen/Core>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Even elastic blocks by another program, CalculiX (Dhondt 2004): bricks with incompatible modes, which bend
/// as solids do. Small displacements.
namespace esm::test {

inline bool hasCalculix() {
    return std::system("command -v ccx >/dev/null 2>&1") == 0;
}

/// A block of bricks between planes across x, y and z.
struct BrickBlock {
    std::vector<double> xs, ys, zs; ///< m, rising
    double youngsModulus;           ///< Pa
    double poissonsRatio;

    int nodeAt(std::size_t x, std::size_t y, std::size_t z) const {
        return static_cast<int>((z * ys.size() + y) * xs.size() + x) + 1;
    }
    std::size_t nodeCount() const { return xs.size() * ys.size() * zs.size(); }
};

using NodeVectors = std::map<int, Eigen::Vector3d>; ///< by node, from 1 on

/// What is asked of a block, and what comes of it.
struct BrickLoads {
    std::map<std::pair<int, int>, double> led;    ///< m, by node and axis (1, 2, 3)
    std::map<std::pair<int, int>, double> forces; ///< N
};
struct BrickRest {
    NodeVectors displacements; ///< m
    NodeVectors forces;        ///< N, on led nodes from outside
};

inline void writeBricks(const BrickBlock& block, const BrickLoads& loads, std::ostream& file) {
    file.precision(12);
    file << "*NODE, NSET=ALL\n";
    for (std::size_t z = 0; z < block.zs.size(); ++z)
        for (std::size_t y = 0; y < block.ys.size(); ++y)
            for (std::size_t x = 0; x < block.xs.size(); ++x)
                file << block.nodeAt(x, y, z) << ", " << block.xs[x] << ", " << block.ys[y] << ", "
                     << block.zs[z] << "\n";
    file << "*ELEMENT, TYPE=C3D8I, ELSET=BODY\n";
    int element = 0;
    for (std::size_t z = 0; z + 1 < block.zs.size(); ++z)
        for (std::size_t y = 0; y + 1 < block.ys.size(); ++y)
            for (std::size_t x = 0; x + 1 < block.xs.size(); ++x) {
                file << ++element;
                for (const std::size_t up : {z, z + 1})
                    file << ", " << block.nodeAt(x, y, up) << ", " << block.nodeAt(x + 1, y, up) << ", "
                         << block.nodeAt(x + 1, y + 1, up) << ", " << block.nodeAt(x, y + 1, up);
                file << "\n";
            }
    file << "*MATERIAL, NAME=TISSUE\n*ELASTIC\n"
         << block.youngsModulus << ", " << block.poissonsRatio
         << "\n*SOLID SECTION, ELSET=BODY, MATERIAL=TISSUE\n*STEP\n*STATIC\n*BOUNDARY\n";
    for (const auto& [place, way] : loads.led)
        file << place.first << ", " << place.second << ", " << place.second << ", " << way << "\n";
    if (!loads.forces.empty()) file << "*CLOAD\n";
    for (const auto& [place, force] : loads.forces)
        file << place.first << ", " << place.second << ", " << force << "\n";
    file << "*NODE PRINT, NSET=ALL\nU, RF\n*END STEP\n";
}

/// The tables of a .dat file: a line of words each, then a node and three numbers in each line.
inline BrickRest readBricks(std::istream& file) {
    BrickRest rest;
    NodeVectors* table = nullptr;
    for (std::string line; std::getline(file, line);) {
        if (line.find("displacements") != std::string::npos) table = &rest.displacements;
        if (line.find("forces") != std::string::npos) table = &rest.forces;
        std::istringstream numbers(line);
        int node = 0;
        Eigen::Vector3d vector;
        if (table && numbers >> node >> vector[0] >> vector[1] >> vector[2]) (*table)[node] = vector;
    }
    return rest;
}

/// @throws std::runtime_error where the program gives no answer
inline BrickRest restOf(const BrickBlock& block, const BrickLoads& loads) {
    const TemporaryFolder folder;
    {
        std::ofstream file(folder / "block.inp");
        writeBricks(block, loads, file);
    }
    const std::string command =
        "cd '" + (folder / "").string() + "' && OMP_NUM_THREADS=1 ccx block >log 2>&1";
    const int status = std::system(command.c_str());
    std::ifstream file(folder / "block.dat");
    BrickRest rest = readBricks(file);
    if (status != 0 || rest.displacements.size() != block.nodeCount())
        throw std::runtime_error("ccx gave no answer");
    return rest;
}

} // namespace esm::test
