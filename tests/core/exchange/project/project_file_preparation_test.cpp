#include "tests/core/exchange/project/project_file_fixture.h"

#include "tests/support/same_project.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using PreparationJson = nlohmann::ordered_json;

TEST_F(ProjectFile, KeepsHowPhotosAreMadeReady) {
    Project project = richProject();
    PhotoPreparation pinhole, fisheye;
    pinhole.field = PhotoField::circle({20.25, 1.0 / 3}, 11, 2.5);
    pinhole.strokes = {{{{1, 1.0 / 3}, {5, 6}}, 4.5, 0.25, false}, {{{2, 2}}, 1, 0, true}};
    pinhole.match = ColourMatch{{1.0 / 0.9, 1, 0.7}, {-1.0 / 3, 5, 6}};
    pinhole.highlightThreshold = 200;
    pinhole.evenLight = 0.7;
    pinhole.whiteBalance = ColourGains{0.9, 1, 1.0 / 0.9};
    pinhole.lens = Lens{LensKind::Pinhole, {30, 31, 20, 19}, {-0.1, 0.01, 0.001, 1.0 / 3000, 0.002}};
    pinhole.crop = PhotoCrop{1, 2, 12, 11};
    fisheye.lens = Lens{LensKind::Fisheye, {9, 9, 8, 8}, {-0.1, 0.01, 0.001, 1.0 / 3000, 0}};
    fisheye.adjustment = {10.0 / 3, 254.5, 1.0 / 3, 1.1, 0, -179.9};
    prepare(project.layers[0], pinhole);
    prepare(project.layers[1], fisheye);
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    EXPECT_EQ(loadProject(m_file).layers[2].prepared, nullptr);
}

TEST_F(ProjectFile, KeepsFieldsAndMasksOfAnyShape) {
    Project project = richProject();
    PhotoPreparation ellipse, polygon;
    ellipse.field = PhotoField{FieldShape::Ellipse, {20.25, 1.0 / 3}, {11, 7}, -1.0 / 3, {}, 2.5};
    ellipse.highlightSensitivity = 1.0 / 3;
    polygon.field = PhotoField{FieldShape::Polygon, {0, 0}, {0, 0}, 0, {{1, 1.0 / 3}, {9, 0}, {4, 8}}, 0};
    polygon.strokes = {{{{1, 1.0 / 3}, {5, 6}, {2, 9}}, 0.5, 0, false, true}};
    prepare(project.layers[0], ellipse);
    prepare(project.layers[1], polygon);
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
}

TEST_F(ProjectFile, NamesWhatIsWrongWithAPreparation) {
    for (
        const auto& [preparation, naming] : std::vector<std::pair<const char*, const char*>>{
            {R"({"evenLight": 2})", "strength of even light"},
            {R"({"strokes": [{"path": [1], "radius": 3, "softness": 0, "takesBack": false}]})", "x and a y"},
            {R"({"strokes": [{"path": [], "radius": 3, "softness": 0, "takesBack": false}]})", "x and a y"},
            {R"({"strokes": [{"path": [1, 2], "radius": 0, "softness": 0, "takesBack": false}]})", "strokes"},
            {R"({"colourMatch": {"scale": [9, 1, 1], "offset": [0, 0, 0]}})", "matched colours"},
            {R"({"highlights": 0})", "preparation.highlights"},
            {R"({"whiteBalance": [1, 2]})", "preparation.whiteBalance"},
            {R"({"whiteBalance": [1, 1, 99]})", "gains of white balance"},
            {R"({"crop": {"x": 0, "y": 0, "width": 9999, "height": 1}})", "a part of the photo"},
            {R"({"roundField": {"centre": [1, 1], "radius": 0, "trim": 2}})", "the field"},
            {R"({"field": {"shape": "star", "trim": 2}})", "ellipse or polygon"},
            {R"({"field": {"shape": "polygon", "corners": [1, 1, 9], "trim": 2}})", "x and a y"},
            {R"({"field": {"shape": "polygon", "corners": [1, 1, 9, 9], "trim": 2}})", "3 to 1000 corners"},
            {R"({"field": {"shape": "ellipse", "centre": [1, 1], "radii": [0, 5], "angle": 0, "trim": 2}})",
             "the radii"},
            {R"({"field": {"shape": "ellipse", "centre": [1, 1], "radii": [3, 5], "trim": 2}})", "angle"},
            {R"({"strokes": [{"path": [1, 2, 3, 4], "radius": 1, "softness": 0, "takesBack": false, "filled": true}]})",
             "at least 3 places"},
            {R"({"highlightSensitivity": 1.5})", "the sensitivity to highlights"},
            {R"({"adjustment": {"hue": 181}})", "the turn of hue must be from -180 to 180 degrees"},
            {R"({"adjustment": {"blackPoint": 99.5, "whitePoint": 100}})", "above the black point"},
            {R"({"adjustment": {"gamma": "bright"}})", "adjustment.gamma"},
            {R"({"lens": {"kind": "mirror", "fx": 1, "fy": 1, "cx": 0, "cy": 0, "coefficients": [0,0,0,0,0]}})",
             "pinhole"},
            {R"({"lens": {"kind": "fisheye", "fx": 0, "fy": 1, "cx": 0, "cy": 0, "coefficients": [0,0,0,0]}})",
             "focal length"}}) {
        changeManifest("/photos/layers/0", [&text = preparation](PreparationJson& layer) {
            layer["preparation"] = PreparationJson::parse(text);
        });
        EXPECT_THAT(loadingError(), testing::HasSubstr(naming)) << preparation;
    }
}

} // namespace
} // namespace esm
