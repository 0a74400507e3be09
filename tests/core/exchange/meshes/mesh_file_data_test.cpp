#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "tests/support/shared_data.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace esm {
namespace {

/// What the data's inventory says of each file.
struct Inventory {
    const char* file;
    std::size_t vertices, triangles, parts, boundaryEdges, nonManifoldEdges, duplicates;
};

void PrintTo(const Inventory& inventory, std::ostream* out) {
    *out << inventory.file;
}

class MeshData : public testing::TestWithParam<Inventory> {};

TEST_P(MeshData, AgreesWithItsInventory) {
    const Inventory& expected = GetParam();
    const auto file = sharedData("meshes") / expected.file;
    ESM_SKIP_WITHOUT(file);
    const PolygonSoup soup = readMeshFile(file);
    std::size_t triangles = 0;
    for (const auto& polygon : soup.polygons)
        triangles += polygon.size() - 2;
    EXPECT_EQ(soup.vertices.size(), expected.vertices);
    EXPECT_EQ(triangles, expected.triangles);

    const RepairedMesh repaired = repair(soup);
    EXPECT_EQ(repaired.report.components, expected.parts);
    EXPECT_EQ(repaired.report.boundaryEdgesBefore, expected.boundaryEdges);
    EXPECT_EQ(repaired.report.nonManifoldEdgesBefore, expected.nonManifoldEdges);
    EXPECT_EQ(repaired.report.duplicateTriangles, expected.duplicates);
    EXPECT_EQ(repaired.report.degenerateTriangles, 0U);
    EXPECT_EQ(repaired.mesh.triangles.size(), expected.triangles - expected.duplicates);
}

INSTANTIATE_TEST_SUITE_P(
    AllFiles, MeshData,
    testing::Values(Inventory{"sofa-liver-coarse.obj", 181, 274, 1, 0, 0, 0},
                    Inventory{"liver-smoothUV.obj", 2194, 4384, 1, 0, 0, 0},
                    Inventory{"sofa-aneurysm.off", 7095, 14186, 1, 0, 0, 0},
                    Inventory{"sofa-head-quads-uv.obj", 3931, 7820, 1, 40, 0, 0},
                    Inventory{"sofa-skull-and-teeth-coarse.obj", 4775, 9427, 34, 3, 3, 3},
                    Inventory{"VH_F_Uterus.glb", 20151, 37184, 2, 78, 576, 235},
                    Inventory{"VH_F_Fallopian_Tube_L.glb", 9282, 18281, 1, 47, 0, 0},
                    Inventory{"VH_F_Skin.glb", 62176, 124348, 1, 0, 0, 0},
                    Inventory{"VH_F_Vasculature.glb", 111520, 218216, 22, 1690, 0, 0},
                    Inventory{"VH_M_Liver.glb", 31264, 60369, 10, 733, 1050, 718},
                    Inventory{"SBU_F_Intestine_Large.glb", 10636, 20421, 1, 52, 195, 0},
                    Inventory{"GCA-VHF-large-intestine.vtk", 10137, 20419, 1, 58, 195, 0},
                    Inventory{"GCA-00020-transverse-colon-open.vtk", 15592, 30956, 1, 240, 0, 0},
                    Inventory{"sks-liver-downsample.stl", 15504, 5168, 1, 0, 0, 0},
                    Inventory{"sks-liver-coloured.ply", 2002, 4000, 1, 0, 0, 0},
                    Inventory{"sks-tumour.ply", 4943, 10000, 5, 0, 31, 10},
                    Inventory{"sks-prostate-phantom.vtk", 12448, 25000, 6, 0, 46, 15},
                    Inventory{"sks-liver-H07.ply", 11012, 22000, 8, 0, 0, 0},
                    Inventory{"colin27-lateral-ventricles-ascii.stl", 82956, 27652, 1, 0, 0, 0}),
    [](const auto& test) {
        std::string name = test.param.file;
        std::replace_if(
            name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
        return name;
    });

/// The same colon in metres with Y up and in millimetres with Z up.
TEST(MeshData, UnitAndUpAxisBringTheTwoColonsTogether) {
    const auto metresFile = sharedData("meshes/SBU_F_Intestine_Large.glb");
    const auto millimetresFile = sharedData("meshes/GCA-VHF-large-intestine.vtk");
    ESM_SKIP_WITHOUT(metresFile);
    ESM_SKIP_WITHOUT(millimetresFile);
    PolygonSoup first = readMeshFile(metresFile), second = readMeshFile(millimetresFile);
    convertToMetres(first, LengthUnit::Metre, UpAxis::Y);
    convertToMetres(second, LengthUnit::Millimetre, UpAxis::Z);
    const TriangleMesh a = repair(first).mesh, b = repair(second).mesh;
    const Eigen::AlignedBox3d boxA = boundingBox(a.vertices), boxB = boundingBox(b.vertices);
    EXPECT_LT((boxA.min() - boxB.min()).norm(), 1e-5);
    EXPECT_LT((boxA.max() - boxB.max()).norm(), 1e-5);
    EXPECT_NEAR(surfaceArea(a), surfaceArea(b), 1e-4 * surfaceArea(a));
    double farthest = 0;
    for (const Eigen::Vector3d& vertex : b.vertices) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& other : a.vertices)
            nearest = std::min(nearest, (vertex - other).squaredNorm());
        farthest = std::max(farthest, nearest);
    }
    EXPECT_LT(std::sqrt(farthest), 1e-5) << "every point of the one is a point of the other";
}

} // namespace
} // namespace esm
