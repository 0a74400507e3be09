#include "tests/core/exchange/project/project_file_fixture.h"

#include "core/exchange/fuzzy/fuzzy_file.h"
#include "core/samples/samples.h"
#include "core/texture/texture_limits.h"
#include "tests/support/full_disk.h"
#include "tests/support/same_project.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <ctime>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ProjectFile, ComesBackBitByBit) {
    const Project project = richProject();
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
}

TEST_F(ProjectFile, KeepsHowFewerNodesCarryTheSurface) {
    for (const Project& project :
         {boundProject({Detail::Kind::Nodes, 20}), boundProject({Detail::Kind::Rigid, 0}), latticeProject(),
          rowsProject(3), rowsProject(4), rowsProject(9)}) {
        saveProject(project, m_file);
        expectSameProject(project, loadProject(m_file));
        EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
    }
}

TEST_F(ProjectFile, HoldsShorterRowsOfNodesWithThree) {
    for (const std::size_t length : {1U, 2U}) {
        const Project project = rowsProject(length);
        saveProject(project, m_file);
        const Bytes bytes = readFile(m_file);
        const Project loaded = loadProject(m_file);
        const BindingRows& rows = loaded.network->binding->vertices;
        EXPECT_EQ(rows.nodes.size(), 3 * project.mesh->vertices.size());
        std::vector<Eigen::Vector3d> positions = project.network->restPositions;
        for (std::size_t node = 0; node < positions.size(); ++node)
            positions[node] *= 1 + 0.01 * double(node);
        EXPECT_EQ(drawnPositions(*loaded.mesh, *loaded.network, positions),
                  drawnPositions(*project.mesh, *project.network, positions));
        saveProject(loaded, m_file);
        EXPECT_EQ(readFile(m_file), bytes);
    }
}

TEST_F(ProjectFile, KeepsBiphasicSprings) {
    saveProject(biphasicProject(), m_file);
    expectSameProject(biphasicProject(), loadProject(m_file));
}

TEST_F(ProjectFile, KeepsNormsWeightsAndConditionsOfEveryKind) {
    saveProject(extendedInferenceProject(), m_file);
    expectSameProject(extendedInferenceProject(), loadProject(m_file));
}

TEST_F(ProjectFile, KeepsSoftRims) {
    saveProject(softProject(), m_file);
    expectSameProject(softProject(), loadProject(m_file));
}

TEST_F(ProjectFile, KeepsPerspectiveProjectors) {
    Project project = richProject();
    for (TextureLayer& layer : project.layers)
        layer.projector = {};
    project.layers[0].projector.kind = ProjectorKind::Perspective;
    project.layers[0].projector.fieldOfView = 100.0 / 3;
    project.layers[1].projector.kind = ProjectorKind::Perspective;
    project.layers[1].projector.intrinsics = Intrinsics{1e4 / 3, 900, -3, 0.1};
    project.layers[2].projector.falloff = true;
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
}

TEST_F(ProjectFile, KeepsWhatIsPaintedAndHowLayersBlend) {
    saveProject(paintedProject(), m_file);
    expectSameProject(paintedProject(), loadProject(m_file));
    EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
}

TEST_F(ProjectFile, WithoutASpringLawHasLinearSprings) {
    changeManifest("/base", [](Json& base) { EXPECT_FALSE(base.contains("stiffening")); });
    EXPECT_FALSE(loadProject(m_file).base.stiffening);
    EXPECT_FALSE(evaluateModel(loadProject(m_file)).stiffening);
}

TEST_F(ProjectFile, IsOfTheVersionThatProgramsNeedToReadIt) {
    const auto version = [&](const Project& project) {
        saveProject(project, m_file);
        const Bytes bytes = readFile(m_file), text = ZipReader(bytes).read(project_layout::manifest, 1 << 20);
        return Json::parse(text.begin(), text.end())["version"].get<int>();
    };
    EXPECT_EQ(version(richProject()), 1);
    EXPECT_EQ(version(boundProject({Detail::Kind::Nodes, 20})), 2);
    EXPECT_EQ(version(biphasicProject()), 3);
    EXPECT_EQ(version(extendedInferenceProject()), 4);
    EXPECT_EQ(version(softProject()), 5);
    Project project = richProject();
    project.layers[0].projector.falloff = true;
    EXPECT_EQ(version(project), 6);
    project.layers[0].projector.falloff = false;
    project.layers[0].projector.kind = ProjectorKind::Perspective;
    EXPECT_EQ(version(project), 6);
    project.layers[0].preparation.evenLight = 0.5;
    EXPECT_EQ(version(project), 7);
    project.layers[0].preparation.strokes = {PhotoStroke{{{1, 2}}, 3, 0, false}};
    EXPECT_EQ(version(project), 8);
    project.layers[0].preparation.strokes.clear();
    project.layers[0].preparation.match = ColourMatch();
    EXPECT_EQ(version(project), 8);
    project.layers[0].preparation.match.reset();
    EXPECT_EQ(version(project), 7);
    project.layers[0].blending = Blending::Multiply;
    EXPECT_EQ(version(project), 8);
    EXPECT_EQ(version(paintedProject()), 8);
    EXPECT_EQ(version(shiningProject()), 11);
    project.texture.finish.emplace();
    EXPECT_EQ(version(project), 11);
    Project marked = richProject();
    marked.layers[0].landmarks = {{{1, 2}, {3, 4, 5}}};
    EXPECT_EQ(version(marked), 8);
    marked.scene.instruments = {{Capsule{0.01, 0.1}, {{0, {0, 0, 0}}}, {}, {}}};
    EXPECT_EQ(version(marked), 9);
    Project split = richProject();
    split.scene.splits = {{0.5, {{0, 1}}}};
    EXPECT_EQ(version(split), 9);
    EXPECT_EQ(version(latticeProject()), 9);
    EXPECT_EQ(version(rowsProject(3)), 2);
    EXPECT_EQ(version(rowsProject(4)), 9);
    Project shaped = richProject();
    const auto versionWith = [&](const PhotoPreparation& preparation) {
        shaped.layers[0].preparation = preparation;
        return version(shaped);
    };
    PhotoPreparation circle, ellipse, outline, sensitive, adjusted;
    circle.field = PhotoField::circle({5, 5}, 4);
    EXPECT_EQ(versionWith(circle), 7);
    ellipse.field = PhotoField{FieldShape::Ellipse, {5, 5}, {4, 3}, 0, {}, 2};
    EXPECT_EQ(versionWith(ellipse), 10);
    outline.strokes = {{{{1, 1}, {5, 6}, {2, 9}}, 0.5, 0, false, true}};
    EXPECT_EQ(versionWith(outline), 10);
    sensitive.highlightSensitivity = 0.5;
    EXPECT_EQ(versionWith(sensitive), 10);
    adjusted.adjustment.hue = 5;
    EXPECT_EQ(versionWith(adjusted), 11);
    EXPECT_EQ(version(filledProject()), 12);
    EXPECT_EQ(version(sheetProject()), projectFileVersion);
    EXPECT_EQ(version(clinicalProject()), projectFileVersion);
    Project wall = filledProject();
    wall.base.resistsBending = true;
    EXPECT_EQ(version(wall), projectFileVersion);
    Project pressed = paintedProject();
    for (TextureLayer& layer : pressed.layers)
        for (auto& stroke : layer.strokes) {
            BrushStroke light = *stroke;
            light.shares.assign(light.path.size(), {0.5, 1});
            stroke = std::make_shared<const BrushStroke>(light);
        }
    EXPECT_EQ(version(pressed), 11);
    Project healed = paintedProject();
    BrushStroke healing;
    healing.kind = BrushKind::Heal;
    healing.path = {{{0, 0, 0}, {0, 0, 1}}};
    healed.layers.back().strokes = {std::make_shared<const BrushStroke>(healing)};
    EXPECT_EQ(version(healed), 11);
    Project blended = richProject();
    for (const Blending blending : {Blending::Screen, Blending::Overlay, Blending::Colour}) {
        blended.layers[0].blending = blending;
        EXPECT_EQ(version(blended), 11) << wordOf(blending);
    }
}

TEST_F(ProjectFile, OfAVersionTooLowOpensWithAWarning) {
    changeManifestOf(softProject(), "/version", [](Json& version) { version = 1; });
    const OpenedProject opened = openProject(m_file);
    expectSameProject(softProject(), opened.project);
    EXPECT_THAT(opened.warnings, testing::ElementsAre(HasSubstr("version should be 5")));
    EXPECT_EQ(validateProjectFile(m_file), opened.warnings);
}

TEST_F(ProjectFile, OfWhatIsHardlyMeantOpensWithAWarning) {
    Project project = boundProject({Detail::Kind::Nodes, 20});
    TriangleMesh mesh = *project.mesh;
    mesh.vertices[5].x() = 1e300;
    project.mesh = std::make_shared<TriangleMesh>(mesh);
    SpringNetwork network = *project.network;
    network.springs[0].restLength = 50;
    project.network = std::make_shared<SpringNetwork>(network);
    saveProject(project, m_file);
    const OpenedProject opened = openProject(m_file);
    expectSameProject(project, opened.project);
    EXPECT_THAT(opened.warnings, testing::ElementsAre(HasSubstr("mesh point"), HasSubstr("rest length")));
    EXPECT_EQ(validateProjectFile(m_file), opened.warnings);
}

TEST_F(ProjectFile, ABindingThatCannotCarryTheSurfaceIsNotSaved) {
    Project project = boundProject({Detail::Kind::Nodes, 20});
    SpringNetwork network = *project.network;
    network.binding->vertices.starts.pop_back();
    project.network = std::make_shared<SpringNetwork>(network);
    EXPECT_THROW(saveProject(project, m_file), FileError);
}

TEST_F(ProjectFile, KeepsAModelWithoutSurfaceRegionsOrPhotos) {
    saveProject(bareProject(), m_file);
    expectSameProject(bareProject(), loadProject(m_file));
}

TEST_F(ProjectFile, KeepsLandmarks) {
    Project project = richProject();
    project.layers[1].landmarks = {{{1.0 / 3, 20}, {0.1, -1.0 / 7, 1e-9}}, {{-3, 4.5}, {0, 2, 3}}};
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
}

TEST_F(ProjectFile, NamesWhatIsWrongWithLandmarks) {
    for (const auto& [landmarks, naming] : std::vector<std::pair<const char*, const char*>>{
             {R"({})", "landmarks"},
             {R"([{"photo": [1], "organ": [1, 2, 3]}])", "landmarks[0].photo"},
             {R"([{"photo": [1, 2], "organ": [1, "two", 3]}])", "landmarks[0].organ"},
             {R"([{"photo": [1, 2]}])", "landmarks[0].organ"}}) {
        changeManifest("/photos/layers/0",
                       [&text = landmarks](Json& layer) { layer["landmarks"] = Json::parse(text); });
        EXPECT_THAT(loadingError(), testing::HasSubstr(naming)) << landmarks;
    }
    Project project = richProject();
    project.layers[0].landmarks.resize(texture_limits::mostLandmarks + 1, {{1, 2}, {3, 4, 5}});
    EXPECT_THROW(saveProject(project, m_file), FileError);
}

TEST_F(ProjectFile, SharesWhatWasShared) {
    saveProject(richProject(), m_file);
    const Project loaded = loadProject(m_file);
    EXPECT_EQ(loaded.regions[0].system.get(), loaded.regions[1].system.get());
    EXPECT_EQ(loaded.layers[0].photo, loaded.layers[2].photo);
}

TEST_F(ProjectFile, KeysThatAreNotKnownAreIgnored) {
    for (const char* place :
         {"", "/fuzzySystems/0", "/fuzzySystems/0/inputs/zeal", "/regions/0", "/base", "/stepping"}) {
        changeManifest(place, [](Json& object) { object["newer"] = "unheard-of"; });
        EXPECT_EQ(loadingError(), "loaded") << place;
    }
}

TEST_F(ProjectFile, OfProgramsThatKnewOnlyRowsIsLaidInRows) {
    Project expected = richProject();
    expected.texture.atlas.layout = AtlasLayout::Rows;
    auto atlas = std::make_shared<Atlas>(*expected.atlas);
    atlas->options.layout = AtlasLayout::Rows;
    expected.atlas = atlas;
    changeManifest("", [](Json& manifest) {
        for (const char* place : {"texture", "atlas"})
            EXPECT_EQ(manifest[place].erase("layout"), 1U);
    });
    expectSameProject(expected, loadProject(m_file));
}

TEST_F(ProjectFile, AWayToStepThatOnlyOtherProgramsKnowIsLeftOut) {
    saveWithManifest("/stepping/integrator", "leapfrog");
    Project expected = richProject();
    expected.stepping.reset();
    expectSameProject(expected, loadProject(m_file));
}

TEST_F(ProjectFile, HoldsAPresetWithoutTheDescriptionThatProgramsKnow) {
    Project project = richProject();
    const auto preset = std::make_shared<const FuzzySystem>(fuzzyPreset("susilap-g"));
    FuzzySystem own = *preset;
    own.rules.pop_back();
    project.regions = {project.regions[0], project.regions[1]};
    project.regions[0].system = preset;
    project.regions[1].system = std::make_shared<const FuzzySystem>(own);
    for (Region& region : project.regions)
        region.inputs.clear();
    saveProject(project, m_file);
    const Bytes bytes = readFile(m_file), text = ZipReader(bytes).read(project_layout::manifest, 1 << 20);
    const Json systems = Json::parse(text.begin(), text.end())["fuzzySystems"];
    EXPECT_FALSE(systems[0].contains("description"));
    EXPECT_EQ(systems[1]["description"], own.description);
    expectSameProject(project, loadProject(m_file));
}

TEST_F(ProjectFile, HoldsSystemsThatNoRegionUses) {
    Project project = richProject();
    saveProject(project, m_file);
    const Bytes without = readFile(m_file);
    FuzzySystem own = fuzzyPreset("susilap-g");
    own.name = "spare";
    project.spareSystems = {std::make_shared<const FuzzySystem>(own)};
    saveProject(project, m_file);
    const Project loaded = loadProject(m_file);
    expectSameProject(project, loaded);
    ASSERT_EQ(loaded.spareSystems, project.spareSystems);
    EXPECT_TRUE(validateProjectFile(m_file).empty());
    project.spareSystems = {std::make_shared<const FuzzySystem>(fuzzyPreset("robo-sim"))};
    saveProject(project, m_file);
    EXPECT_EQ(readFile(m_file), without) << "what ships is not stored for nobody";
}

TEST_F(ProjectFile, AsksForAVersionThatKnowsWhatASpareSystemHas) {
    Project project = makeSample("tube");
    saveProject(project, m_file);
    const auto version = [&] {
        const Bytes bytes = readFile(m_file), text = ZipReader(bytes).read(project_layout::manifest, 1 << 20);
        return Json::parse(text.begin(), text.end())["version"].get<int>();
    };
    const int before = version();
    FuzzySystem own = fuzzyPreset("susilap-g");
    own.name = "spare";
    own.rules[0].weight = 0.5;
    project.spareSystems = {std::make_shared<const FuzzySystem>(own)};
    saveProject(project, m_file);
    EXPECT_LT(before, 4);
    EXPECT_EQ(version(), 4);
}

TEST_F(ProjectFile, TheSameProjectGivesTheSameBytes) {
    saveProject(richProject(), m_file);
    const Bytes once = readFile(m_file);
    ::setenv("TZ", "Pacific/Auckland", 1);
    ::tzset();
    const std::filesystem::path again = m_folder / "again.esm";
    saveProject(loadProject(m_file), again);
    ::unsetenv("TZ");
    ::tzset();
    EXPECT_EQ(once, readFile(again));
}

TEST_F(ProjectFile, WhatCouldNotBeLoadedIsNotSaved) {
    for (const AtlasOptions& options :
         {AtlasOptions{20000, 1, 2}, {1024, 65, 2}, {16384, 5, 2}, {64, 1, 20000}}) {
        Project project = richProject();
        project.texture.atlas = options;
        EXPECT_THROW(saveProject(project, m_file), FileError) << options.size;
    }
    EXPECT_FALSE(std::filesystem::exists(m_file));
}

TEST_F(ProjectFile, AProjectWithProblemsIsNotSavedOverAGoodOne) {
    saveProject(richProject(), m_file);
    const Bytes before = readFile(m_file);
    Project bad = richProject();
    bad.base.mass = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(saveProject(bad, m_file), FileError);
    bad = richProject();
    bad.layers[0].projector.pose.linear() *= 2;
    EXPECT_THROW(saveProject(bad, m_file), FileError);
    bad = richProject();
    auto atlas = std::make_shared<Atlas>(*bad.atlas);
    atlas->corners[0][0].x() = std::numeric_limits<double>::infinity();
    bad.atlas = atlas;
    EXPECT_THROW(saveProject(bad, m_file), FileError);
    EXPECT_EQ(before, readFile(m_file));
}

TEST_F(ProjectFile, AFullDiskLeavesTheOldFile) {
    saveProject(richProject(), m_file);
    const Bytes before = readFile(m_file);
    const Project larger = richProject(40);
    EXPECT_TRUE(throwsOnFullDisk<FileError>(before.size(), [&] { saveProject(larger, m_file); }));
    EXPECT_EQ(before, readFile(m_file));
    const auto files = std::distance(std::filesystem::directory_iterator(m_folder.path()), {});
    EXPECT_EQ(files, 1);
}

TEST_F(ProjectFile, NamesThatOnlyBytesBeyondUnicodeTellApartAreNotSaved) {
    Project project = richProject();
    FuzzySystem system = *project.regions[0].system;
    system.outputs[0].terms[0].name = "thin\xfe";
    system.outputs[0].terms[1].name = "thin\xff";
    project.regions[0].system = std::make_shared<const FuzzySystem>(system);
    EXPECT_THROW(saveProject(project, m_file), FileError);
    EXPECT_FALSE(std::filesystem::exists(m_file));
}

TEST_F(ProjectFile, NamesThatAreNoUnicodeAreStillSaved) {
    Project project = richProject();
    project.name = "Leber \xe4";
    saveProject(project, m_file);
    EXPECT_EQ(loadProject(m_file).name, "Leber \xef\xbf\xbd");
}

} // namespace
} // namespace esm
