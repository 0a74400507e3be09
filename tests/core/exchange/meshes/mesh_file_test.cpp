#include "core/exchange/meshes/mesh_file.h"

#include "core/decoding/decoder_process.h"
#include "core/support/errors.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/decode_with.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <string>

namespace esm {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

std::string meshError(const fs::path& file) {
    try {
        readMeshFile(file);
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(file.string() + ": "));
        return error.what();
    }
    return "no error";
}

/// A whole PLY file of zeros that takes no room on the disk.
fs::path sparsePly(const fs::path& file, std::uint64_t vertices) {
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                               std::to_string(vertices) +
                               "\nproperty double x\nproperty double y\nproperty double z\n"
                               "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    overwrite(file, header);
    fs::resize_file(file, header.size() + 24 * vertices + 1);
    return file;
}

TEST(MeshFile, ConvertsUnitAndUpAxis) {
    PolygonSoup soup{{{10, 20, 30}}, {}};
    convertToMetres(soup, LengthUnit::Millimetre, UpAxis::Z);
    EXPECT_LT((soup.vertices[0] - Eigen::Vector3d(0.010, 0.030, -0.020)).norm(), 1e-15);
    convertToMetres(soup, LengthUnit::Centimetre, UpAxis::Y);
    EXPECT_LT((soup.vertices[0] - Eigen::Vector3d(0.00010, 0.00030, -0.00020)).norm(), 1e-15);
    convertToMetres(soup, LengthUnit::Metre, UpAxis::Y);
    EXPECT_LT((soup.vertices[0] - Eigen::Vector3d(0.00010, 0.00030, -0.00020)).norm(), 1e-15);
}

TEST(MeshFile, TurnsEveryAxisUpWithoutMirroring) {
    const std::array<Eigen::Vector3d, 6> ups{Eigen::Vector3d::UnitY(),  Eigen::Vector3d::UnitZ(),
                                             Eigen::Vector3d::UnitX(),  -Eigen::Vector3d::UnitY(),
                                             -Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitX()};
    for (std::size_t i = 0; i < ups.size(); ++i) {
        const Eigen::Matrix3d turned = turnedUp(wordsOf<UpAxis>[i].value);
        EXPECT_EQ(turned * ups[i], Eigen::Vector3d::UnitY()) << wordsOf<UpAxis>[i].word;
        EXPECT_EQ(turned * turned.transpose(), Eigen::Matrix3d::Identity());
        EXPECT_EQ(turned.determinant(), 1) << "a turn, and no mirror image";
    }
}

TEST(MeshFile, IsReadAsItsDecoderHasIt) {
    const TemporaryFolder folder;
    overwrite(folder / "a.obj",
              std::string("v 0 0 0.1\nv 1 0 0\nv 0 1 1e-300\nv 5 5 5\nf 3 2 1\nf 1 2 3 4\n"));
    const PolygonSoup soup = readMeshFile(folder / "a.obj");
    ASSERT_EQ(soup.vertices.size(), 4U);
    EXPECT_EQ(soup.vertices[0].z(), 0.1);
    EXPECT_EQ(soup.vertices[2].z(), 1e-300);
    EXPECT_EQ(soup.polygons, (std::vector<std::vector<std::uint32_t>>{{2, 1, 0}, {0, 1, 2, 3}}));
}

TEST(MeshFile, IsRefusedWithTheDecodersWords) {
    const TemporaryFolder folder;
    overwrite(folder / "two\nlines: a.obj", std::string("v 0 0 0\nv 1 0"));
    overwrite(folder / "b.obj", std::string("v 0 0 0\nv 1 0"));
    EXPECT_THAT(meshError(folder / "b.obj"),
                HasSubstr("b.obj: has a vertex without three numbers in line 2"));
    EXPECT_THAT(meshError(folder / "two\nlines: a.obj"),
                HasSubstr("a.obj: has a vertex without three numbers"));
    EXPECT_THAT(meshError(folder / "none.obj"), HasSubstr("does not exist"));
    EXPECT_THAT(meshError(folder / "none.gltf"), HasSubstr("does not exist"));
    EXPECT_THAT(meshError(folder.path()), HasSubstr("not a regular file"));
}

TEST(MeshFile, IsToldAgainByANameThatPackagesHold) {
    const TemporaryFolder folder;
    for (const auto& [name, told] :
         std::vector<std::pair<std::string, std::string>>{{"liver 1 ü.stl", "liver 1 ü.stl"},
                                                          {"a\nb\x1b.stl", "a\xEF\xBF\xBD"
                                                                           "b\xEF\xBF\xBD.stl"},
                                                          {"\xE4.stl", "\xEF\xBF\xBD.stl"}}) {
        overwrite(folder / name, std::string("solid"));
        const MeshSource source = meshSourceOf(folder / name);
        EXPECT_EQ(source.file, told);
        EXPECT_THAT(validate(source), testing::IsEmpty());
    }
}

TEST(MeshFile, MayBeNamedLikeAnOption) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    overwrite("--help.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_EQ(readMeshFile("--help.obj").polygons.size(), 1U);
    fs::current_path(before);
}

TEST(MeshFile, CostsAMessageWhenItsDecoderFails) {
    const TemporaryFolder folder;
    const DecodeWith standIn(failingDecoder());
    for (const char* role : {"abort", "crash", "exit"}) {
        const fs::path file = folder / (std::string(role) + ".ply");
        overwrite(file, std::string("ply\n"));
        EXPECT_THAT(meshError(file), HasSubstr("decoder failed")) << role;
    }
    for (const char* role : {"nonsense", "silent", "half", "lies", "corner", "place"}) {
        const fs::path file = folder / (std::string(role) + ".ply");
        overwrite(file, std::string("ply\n"));
        EXPECT_THAT(meshError(file), HasSubstr("makes no sense")) << role;
    }
}

TEST(MeshFile, MayTakeTheMostWhereItsNumbersLieInOtherFiles) {
    const TemporaryFolder folder;
    const DecodeWith standIn(failingDecoder());
    for (const char* name : {"limits.gltf", "limits.GLTF", "limits.Gltf"}) {
        overwrite(folder / name, std::string("{}"));
        EXPECT_THAT(meshError(folder / name),
                    HasSubstr(std::to_string(largestMeshDecodingLimits().memory) + " bytes"));
    }
}

TEST(MeshFile, IsRefusedUnreadWhereItCannotFitIntoMemory) {
    const TemporaryFolder folder;
    const fs::path file = sparsePly(folder / "huge.ply", 210'000'000); // of 5 GB
    const DecodeWith none("none is started");
    EXPECT_THAT(meshError(file), AllOf(HasSubstr("5.0 GB"), HasSubstr("reduce the mesh")));
}

TEST(MeshFile, IsRefusedWhereReadingItTakesTooMuchMemory) {
    if (isSanitized()) GTEST_SKIP() << "addresses are not limited under the address sanitizer";
    const TemporaryFolder folder;
    const fs::path file = sparsePly(folder / "large.ply", 40'000'000); // of 1 GB
    const DecodingTask task{file, {"mesh", file.string()}, nullptr, {600'000'000, 1'000'000'000, 60}};
    try {
        decodeApart(task, {});
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("0.6 GB of memory"));
    }
}

TEST(MeshFile, CanBeCancelledWhileItIsRead) {
    const TemporaryFolder folder;
    const fs::path file = sparsePly(folder / "large.ply", 40'000'000);
    int asked = 0;
    EXPECT_THROW(readMeshFile(file, [&](double) { return ++asked > 1; }), Cancelled);
    EXPECT_EQ(asked, 1);
}

} // namespace
} // namespace esm
