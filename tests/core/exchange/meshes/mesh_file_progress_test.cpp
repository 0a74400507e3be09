#include "core/exchange/meshes/mesh_file.h"

#include "tests/core/exchange/kept_file.h"

#include <fstream>

namespace esm {
namespace {

using MeshFileProgress = KeptFile;

TEST_F(MeshFileProgress, OfReadingAMeshIsSteady) {
    const std::filesystem::path mesh = folder / "organ.obj";
    std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const std::vector<double> told =
        test::toldBy([&](const Progress& progress) { readMeshFile(mesh, progress); });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
    test::expectStopsAnywhere([&](const Progress& progress) { readMeshFile(mesh, progress); });
}

} // namespace
} // namespace esm
