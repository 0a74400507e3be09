#include "core/authoring/import_unit.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/geometry/repair.h"
#include "tests/support/shared_data.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

TEST(ImportUnit, GivesTheOrganAUsualSize) {
    EXPECT_EQ(recommendedUnit(200, "obj"), LengthUnit::Millimetre);
    EXPECT_EQ(recommendedUnit(0.2, "obj"), LengthUnit::Metre);
    EXPECT_EQ(recommendedUnit(6, "obj"), LengthUnit::Centimetre);
    EXPECT_EQ(recommendedUnit(50, "obj"), LengthUnit::Millimetre) << "files are in millimetres more often";
    EXPECT_EQ(recommendedUnit(0, "obj"), LengthUnit::Millimetre);
}

TEST(ImportUnit, IsMetresWhereTheFormatSaysSo) {
    EXPECT_EQ(recommendedUnit(1.7, "glb"), LengthUnit::Metre);
    EXPECT_EQ(recommendedUnit(0.005, "gltf"), LengthUnit::Metre);
    EXPECT_EQ(recommendedUnit(200, "glb"), LengthUnit::Millimetre) << "no organ is 200 m large";
    EXPECT_EQ(recommendedUnit(1e9, "glb"), LengthUnit::Metre);
}

TEST(ImportUnit, IsNeverOneThatWouldBeDoubtedWhereAnotherWouldNot) {
    for (double extent = 1e-7; extent < 1e7; extent *= 1.1)
        for (const char* ending : {"obj", "glb"}) {
            const bool isSound = isPlausibleSize(extent * metresPer(recommendedUnit(extent, ending)));
            EXPECT_EQ(isSound, !fittingUnits(extent).empty()) << extent << ' ' << ending;
        }
}

TEST(ImportUnit, IsDoubtedOnlyWhereNoOrganHasTheSize) {
    EXPECT_FALSE(isPlausibleSize(0.0009));
    EXPECT_TRUE(isPlausibleSize(0.001));
    EXPECT_TRUE(isPlausibleSize(3));
    EXPECT_FALSE(isPlausibleSize(3.1));
    const std::vector<FittingUnit> fitting = fittingUnits(200);
    ASSERT_EQ(fitting.size(), 2U);
    EXPECT_EQ(fitting[0].unit, LengthUnit::Millimetre);
    EXPECT_EQ(fitting[0].size, 0.2);
    EXPECT_EQ(fitting[1].unit, LengthUnit::Centimetre);
    EXPECT_TRUE(fittingUnits(1e-9).empty());
}

/// A file, the largest side of its box in its own unit, and the unit to recommend.
struct MeasuredFile {
    const char* file;
    double extent;
    LengthUnit unit;
};

void PrintTo(const MeasuredFile& measured, std::ostream* out) {
    *out << measured.file;
}

class ImportUnitOfData : public testing::TestWithParam<MeasuredFile> {};

TEST_P(ImportUnitOfData, IsTheFilesOwn) {
    const std::filesystem::path file = sharedData("meshes") / GetParam().file;
    ESM_SKIP_WITHOUT(file);
    const double extent = boundingBox(repair(readMeshFile(file)).mesh.vertices).sizes().maxCoeff();
    EXPECT_NEAR(extent / GetParam().extent, 1, 1e-3);
    EXPECT_EQ(recommendedUnit(extent, meshFileEnding(file)), GetParam().unit);
}

constexpr LengthUnit mm = LengthUnit::Millimetre, cm = LengthUnit::Centimetre, m = LengthUnit::Metre;

/// Those of SOFA (the last five) are in units of their own, of which nobody says how long they are.
INSTANTIATE_TEST_SUITE_P(
    AllFiles, ImportUnitOfData,
    testing::Values(
        MeasuredFile{"GCA-00020-transverse-colon-open.vtk", 328.3, mm},
        MeasuredFile{"GCA-VHF-large-intestine.vtk", 294.9, mm},
        MeasuredFile{"SBU_F_Intestine_Large.glb", 0.2949, m},
        MeasuredFile{"VH_F_Fallopian_Tube_L.glb", 0.04447, m}, MeasuredFile{"VH_F_Skin.glb", 1.667, m},
        MeasuredFile{"VH_F_Uterus.glb", 0.0587, m}, MeasuredFile{"VH_F_Vasculature.glb", 0.5831, m},
        MeasuredFile{"VH_M_Liver.glb", 0.2018, m},
        MeasuredFile{"colin27-lateral-ventricles-ascii.stl", 92, mm},
        MeasuredFile{"sks-liver-H07.ply", 199.9, mm}, MeasuredFile{"sks-liver-coloured.ply", 231.8, mm},
        MeasuredFile{"sks-liver-downsample.stl", 226.7, mm},
        MeasuredFile{"sks-prostate-phantom.vtk", 112.5, mm}, MeasuredFile{"sks-tumour.ply", 44.94, mm},
        MeasuredFile{"sofa-aneurysm.off", 33.2, mm}, MeasuredFile{"liver-smoothUV.obj", 6.386, cm},
        MeasuredFile{"sofa-head-quads-uv.obj", 13.35, cm}, MeasuredFile{"sofa-liver-coarse.obj", 6.483, cm},
        MeasuredFile{"sofa-skull-and-teeth-coarse.obj", 8.658, cm}));

} // namespace
} // namespace esm
