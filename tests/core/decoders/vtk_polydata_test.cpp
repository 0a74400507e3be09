#include "core/decoders/vtk_polydata.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace esm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using Polygons = std::vector<std::vector<std::uint32_t>>;

PolygonSoup parse(const std::string& text) {
    return parseVtkPolydata("some.vtk", Bytes(text.begin(), text.end()));
}

std::string errorOf(const std::string& text) {
    try {
        parse(text);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no error";
}

std::string header(const std::string& form = "ASCII", const std::string& version = "3.0") {
    return "# vtk DataFile Version " + version + "\na title with POINTS in it\n" + form +
           "\nDATASET POLYDATA\n";
}

template<typename Number> std::string bigEndian(std::initializer_list<Number> numbers) {
    std::string bytes;
    for (const Number number : numbers) {
        std::string raw(sizeof number, '\0');
        std::memcpy(raw.data(), &number, sizeof number);
        bytes.append(raw.rbegin(), raw.rend());
    }
    return bytes;
}

const std::string square = "POINTS 4 float\n0 0 0 1 0 0 1 1 0\n0 1 0\n";

TEST(VtkPolydata, ReadsPolygonsOfAnySize) {
    const PolygonSoup soup = parse(header() + square + "POLYGONS 2 9\n4 0 1 2 3\n3 0 1 2\n");
    EXPECT_EQ(soup.vertices.size(), 4U);
    EXPECT_EQ(soup.vertices[2], Eigen::Vector3d(1, 1, 0));
    EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2, 3}, {0, 1, 2}}));
}

TEST(VtkPolydata, TurnsStripsIntoTrianglesOfOneDirection) {
    const PolygonSoup soup = parse(header() + square + "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\n");
    EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 3}, {3, 1, 2}}));
}

TEST(VtkPolydata, SkipsWhatIsNoSurface) {
    const PolygonSoup soup = parse(
        header() + "FIELD FieldData 2\nTIME 1 1 double\n0.5\nids 2 2 int\n1 2 3 4\n" + square +
        "METADATA\nINFORMATION 1\nNAME x LOCATION y\nDATA 2 0 1\n\nVERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\n"
        "POLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nSCALARS a float 1\nLOOKUP_TABLE default\n7\n");
    EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2}}));
}

TEST(VtkPolydata, ReadsBinaryNumbersOfEveryKind) {
    const std::string cells = "\nPOLYGONS 1 4\n" + bigEndian<std::int32_t>({3, 0, 1, 2}) + "\n";
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"float", bigEndian<float>({0, 0, 0, 1, 0, 0, 1, -1, 0})},
        {"double", bigEndian<double>({0, 0, 0, 1, 0, 0, 1, -1, 0})},
        {"int", bigEndian<std::int32_t>({0, 0, 0, 1, 0, 0, 1, -1, 0})},
        {"short", bigEndian<std::int16_t>({0, 0, 0, 1, 0, 0, 1, -1, 0})},
        {"char", bigEndian<std::int8_t>({0, 0, 0, 1, 0, 0, 1, -1, 0})},
        {"long", bigEndian<std::int64_t>({0, 0, 0, 1, 0, 0, 1, -1, 0})}};
    for (const auto& [name, numbers] : kinds) {
        const PolygonSoup soup = parse(header("BINARY") + "POINTS 3 " + name + "\n" + numbers + cells);
        ASSERT_EQ(soup.vertices.size(), 3U) << name;
        EXPECT_EQ(soup.vertices[2], Eigen::Vector3d(1, -1, 0)) << name;
        EXPECT_EQ(soup.polygons, (Polygons{{0, 1, 2}})) << name;
    }
    const PolygonSoup unsignedBytes = parse(header("BINARY") + "POINTS 3 unsigned_char\n" +
                                            bigEndian<std::uint8_t>({0, 0, 0, 255, 0, 0, 1, 1, 0}) + cells);
    EXPECT_EQ(unsignedBytes.vertices[1].x(), 255);
}

TEST(VtkPolydata, ReadsBinaryDataThatLooksLikeWhitespace) {
    const PolygonSoup soup = parse(header("BINARY") + "POINTS 3 char\n" + std::string(9, '\n') +
                                   "\nPOLYGONS 1 4\n" + bigEndian<std::int32_t>({3, 0, 1, 2}));
    EXPECT_EQ(soup.vertices[2], Eigen::Vector3d(10, 10, 10));
}

TEST(VtkPolydata, ReadsOffsetsAndConnectivityOfVersion5) {
    const PolygonSoup text =
        parse(header("ASCII", "5.1") + square +
              "POLYGONS 3 7\nOFFSETS vtktypeint64\n0 4 7\nCONNECTIVITY vtktypeint64\n0 1 2 3\n0 1 2\n");
    EXPECT_EQ(text.polygons, (Polygons{{0, 1, 2, 3}, {0, 1, 2}}));
    const PolygonSoup binary =
        parse(header("BINARY", "5.1") + "POINTS 3 float\n" + bigEndian<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
              "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" + bigEndian<std::int64_t>({0, 3}) +
              "\nCONNECTIVITY vtktypeint32\n" + bigEndian<std::int32_t>({0, 1, 2}) + "\n");
    EXPECT_EQ(binary.polygons, (Polygons{{0, 1, 2}}));
}

TEST(VtkPolydata, RefusesOtherKindsOfVtk) {
    EXPECT_THAT(errorOf("<VTKFile type=\"PolyData\">"), AllOf(HasSubstr("some.vtk"), HasSubstr("legacy")));
    EXPECT_THAT(errorOf(header("ASCII", "6.0") + square), HasSubstr("6.0"));
    EXPECT_THAT(errorOf("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"),
                HasSubstr("unstructured_grid"));
    EXPECT_THAT(errorOf("# vtk DataFile Version 3.0\nt\nXML\n"), HasSubstr("ASCII nor BINARY"));
}

TEST(VtkPolydata, NamesThePlaceOfWhatIsDamaged) {
    EXPECT_THAT(errorOf(header() + "POINTS 2 float\n0 0 0\n1 zero 0\n"),
                AllOf(HasSubstr("zero"), HasSubstr("line 7")));
    EXPECT_THAT(errorOf(header() + "POINTS 2 float\n0 0 0\n1 0\n"), HasSubstr("cut off"));
    EXPECT_THAT(errorOf(header() + "POINTS 2 quaternion\n"), HasSubstr("quaternion"));
    EXPECT_THAT(errorOf(header() + square + "POLYGONS 1 5\n4 0 1 2 x\n"), HasSubstr("line 9"));
    EXPECT_THAT(errorOf(header() + square + "POLYGONS 1 4\n5 0 1 2\n"), HasSubstr("corners"));
    EXPECT_THAT(errorOf(header() + square + "POLYGONS 1 5\n3 0 1 2 0\n"), HasSubstr("add up"));
    EXPECT_THAT(errorOf(header() + square + "POLYGONS 1 4\n3 0 1 -2\n"), HasSubstr("-2"));
    EXPECT_THAT(errorOf(header() + square + "TETRAHEDRA 1 5\n"), HasSubstr("tetrahedra"));
    EXPECT_THAT(errorOf(header() + square + "POLYGONS 1 4\n3 0 1 2\nPOINTS 1 float\n0 0 0\n"),
                HasSubstr("second list of POINTS"));
    EXPECT_THAT(errorOf(header("BINARY") + "POINTS 9 float\nshort"),
                AllOf(HasSubstr("cut off"), HasSubstr("byte")));
    const std::string five = header("ASCII", "5.1") + square;
    EXPECT_THAT(errorOf(five + "POLYGONS 2 3\nOFFSETS int\n0 9\nCONNECTIVITY int\n0 1 2\n"),
                HasSubstr("offsets"));
    EXPECT_THAT(errorOf(five + "POLYGONS 3 3\nOFFSETS int\n0 3 2\nCONNECTIVITY int\n0 1 2\n"),
                HasSubstr("offsets"));
    EXPECT_THAT(errorOf(five + "POLYGONS 2 3\nCONNECTIVITY int\n0 1 2\n"), HasSubstr("OFFSETS"));
}

} // namespace
} // namespace esm
