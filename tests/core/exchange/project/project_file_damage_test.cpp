#include "tests/core/exchange/project/project_file_fixture.h"

#include "core/support/byte_order.h"
#include "tests/support/same_project.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ProjectFile, AFileCutOffAnywhereIsRefused) {
    saveProject(richProject(), m_file);
    const Bytes whole = readFile(m_file);
    for (std::size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 97) {
        overwrite(m_file, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
        ASSERT_THAT(loadingError(), HasSubstr("organ.esm: ")) << size;
    }
}

TEST_F(ProjectFile, AFlippedByteIsFoundOrHarmless) {
    const Project project = richProject();
    saveProject(project, m_file);
    const Bytes whole = readFile(m_file);
    std::size_t refused = 0, tried = 0;
    for (std::size_t place = 0; place < whole.size(); place += 29, ++tried) {
        Bytes damaged = whole;
        damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ (1U << (place % 8)));
        overwrite(m_file, damaged);
        try {
            const Project loaded = loadProject(m_file);
            expectSameProject(project, loaded);
            ASSERT_FALSE(testing::Test::HasFailure()) << "byte " << place;
        } catch (const FileError&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, tried * 9 / 10);
}

TEST_F(ProjectFile, WhatIsNoProjectIsRefused) {
    EXPECT_THAT(loadingError(), HasSubstr("does not exist"));
    EXPECT_THROW(validateProjectFile(m_file), FileError);
    EXPECT_THROW(loadProject(m_folder.path()), FileError);
    overwrite(m_file, std::string());
    EXPECT_THAT(loadingError(), HasSubstr("is empty"));
    overwrite(m_file, std::string("solid organ\nendsolid\n"));
    EXPECT_THAT(loadingError(), HasSubstr(": is not a project"));
    overwrite(m_file, makeZip({{"word/document.xml", {1, 2, 3}, true}}));
    EXPECT_THAT(loadingError(), HasSubstr("manifest.json is missing"));
}

TEST_F(ProjectFile, ANewerVersionSaysSo) {
    saveWithManifest("/version", 14);
    EXPECT_THAT(loadingError(),
                HasSubstr("organ.esm: was made by a newer version (14) of the program; this one reads "
                          "up to 13; update the program"));
}

void setNumber(ZipEntry& entry, std::size_t place, std::uint32_t number) {
    Bytes bytes;
    appendLittleEndian(bytes, number);
    std::copy(bytes.begin(), bytes.end(), entry.content.begin() + static_cast<std::ptrdiff_t>(4 * place));
}

TEST_F(ProjectFile, RowsOfNodesThatCannotCarryTheSurfaceAreRefused) {
    const Project project = rowsProject(4);
    const auto refusal = [&](const char* entry, std::size_t place, std::uint32_t number) {
        saveChangedOf(project, entry, [&](auto&, ZipEntry& damaged) { setNumber(damaged, place, number); });
        EXPECT_THAT(validateProjectFile(m_file), testing::SizeIs(1)) << entry << " " << number;
        return loadingError();
    };
    const char *starts = project_layout::bindingStarts, *nodes = project_layout::bindingNodes,
               *shares = project_layout::bindingShares;
    const auto vertices = project.mesh->vertices.size();
    for (const auto& [place, number] : std::vector<std::pair<std::size_t, std::uint32_t>>{
             {0, 1}, {1, 0}, {1, 8}, {2, 4294967295U}, {vertices, 0}, {vertices, 4294967295U}})
        EXPECT_THAT(refusal(starts, place, number), HasSubstr("starts of the rows of nodes")) << number;
    EXPECT_THAT(refusal(nodes, 7, 20), HasSubstr("binding/nodes.u32: number 7 is 20"));
    EXPECT_THAT(refusal(shares, 3, 0), HasSubstr("drawn point 0"));
    EXPECT_THAT(refusal(shares, 3, 0xFFF00000), HasSubstr("number 1 is not finite"));
}

TEST_F(ProjectFile, RowsOfNodesOfAnotherNumberThanItClaimsAreRefused) {
    const auto refusal = [&](const char* entry, std::uint64_t count) {
        changeManifestOf(rowsProject(4), "/arrays", [&](Json& arrays) { arrays[entry] = count; });
        return loadingError();
    };
    const char *starts = project_layout::bindingStarts, *nodes = project_layout::bindingNodes;
    EXPECT_THAT(refusal(starts, 1U << 28), HasSubstr(starts));
    EXPECT_THAT(refusal(starts, std::uint64_t{1} << 60), HasSubstr(starts));
    EXPECT_THAT(refusal(starts, 0), HasSubstr(starts));
    EXPECT_THAT(refusal(nodes, 1U << 28), HasSubstr(nodes));
    changeManifestOf(rowsProject(4), "/arrays", [&](Json& arrays) { arrays.erase(starts); });
    EXPECT_NE(loadingError(), "loaded") << "four nodes for each are taken for three";
}

TEST_F(ProjectFile, WithWideRowsInAnOlderVersionOpensWithAWarning) {
    changeManifestOf(latticeProject(), "/version", [](Json& version) { version = 2; });
    const OpenedProject opened = openProject(m_file);
    expectSameProject(latticeProject(), opened.project);
    EXPECT_THAT(opened.warnings, testing::Contains(HasSubstr("version should be 9")));
}

/// A second file entry that names the first one's bytes again.
TEST_F(ProjectFile, APhotoIsNotUnpackedTwice) {
    saveProject(richProject(), m_file);
    const Bytes bytes = readFile(m_file);
    const Bytes text = ZipReader(bytes).read(project_layout::manifest, 1 << 20);
    Json files = Json::parse(text.begin(), text.end())["photos"]["files"];
    files.push_back(files[0]);
    saveWithManifest("/photos/files", files);
    EXPECT_THAT(loadingError(), HasSubstr("photos/0.PNG is named twice"));
}

TEST_F(ProjectFile, PhotosTooLargeTogetherAreRefusedBeforeTheyAreDecoded) {
    Bytes claiming;
    cv::imencode(".bmp", cv::Mat::zeros(8, 8, CV_8UC3), claiming);
    Bytes side;
    appendLittleEndian(side, std::uint32_t{16384});
    for (const std::ptrdiff_t place : {18, 22}) // width and height
        std::copy(side.begin(), side.end(), claiming.begin() + place);
    saveChanged(project_layout::manifest, [&](auto& entries, ZipEntry& entry) {
        Json manifest = Json::parse(entry.content.begin(), entry.content.end());
        std::vector<ZipEntry> added;
        for (const char* name : {"photos/2.bmp", "photos/3.bmp", "photos/4.bmp"}) {
            manifest["photos"]["files"].push_back(
                {{"entry", name}, {"fileName", name}, {"bytes", claiming.size()}});
            added.push_back({name, claiming, false});
        }
        const std::string text = manifest.dump();
        entry.content.assign(text.begin(), text.end());
        entries.insert(entries.end(), added.begin(), added.end());
    });
    const std::vector<std::string> problems = validateProjectFile(m_file);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_THAT(problems[0], HasSubstr("damaged"));
    EXPECT_THAT(problems[2], HasSubstr("more pixels than the project's other photos leave room for"));
}

TEST_F(ProjectFile, CornersBeyondTheirPageAreRefused) {
    saveChanged("atlas/corners.f64", [](auto&, ZipEntry& entry) {
        Bytes far;
        appendLittleEndian(far, 1e300);
        std::copy(far.begin(), far.end(), entry.content.begin());
    });
    EXPECT_THAT(loadingError(), HasSubstr("1 triangle laid out beyond the texture's pages (triangle 0)"));
}

struct ProjectDamage {
    const char* pointer;
    Json value;
    const char* named; ///< what the message must name
};

TEST_F(ProjectFile, ABiphasicLawThatIsNoneIsRefusedByItsName) {
    const std::vector<std::pair<Json, const char*>> cases{
        {5, "base.stiffening"},
        {{{"strain", 0.2}}, "base.stiffening.factor"},
        {{{"strain", "20 %"}, {"factor", 5}}, "base.stiffening.strain"},
        {{{"strain", 0}, {"factor", 5}}, "model: the strain"},
        {{{"strain", 0.2}, {"factor", -5}}, "model: the factor"},
        {{{"strain", 1e31}, {"factor", 5}}, "model: the strain"},
        {{{"strain", 0.2}, {"factor", 1e30}}, "spring constant of stretched springs"}};
    for (const auto& [law, named] : cases) {
        changeManifest("/base", [&law = law](Json& base) { base["stiffening"] = law; });
        EXPECT_THAT(loadingError(), HasSubstr(named)) << law;
    }
}

TEST_F(ProjectFile, StrokesAndBlendingThatAreNoneAreRefusedByTheirName) {
    const std::string place = "/photos/layers/";
    const std::vector<std::pair<std::string, std::pair<Json, const char*>>> cases{
        {"0/blending", {"lighten", "blending should be normal, multiply"}},
        {"0/blending", {3, "blending"}},
        {"3/blending", {"multi-band", "only a photo"}},
        {"0/strokes", {7, "strokes"}},
        {"0/strokes/0/brush", {"pencil", "strokes[0].brush"}},
        {"0/strokes/0/brush", {nullptr, "strokes[0].brush"}},
        {"0/strokes/0/radius", {-1, "stroke 1: the brush's radius"}},
        {"0/strokes/0/radius", {1e4, "stroke 1: the brush's radius"}},
        {"0/strokes/0/softness", {1.5, "softness"}},
        {"0/strokes/0/strength", {"full", "strength"}},
        {"0/strokes/0/points", {0, "points"}},
        {"0/strokes/0/points", {1000000, "points"}},
        {"3/strokes/0/colour", {{1, 2}, "colour"}},
        {"3/strokes/1/shift", {{1, 2}, "shift"}},
    };
    for (const auto& [pointer, damage] : cases) {
        changeManifestOf(paintedProject(), place + pointer,
                         [&value = damage.first](Json& old) { old = value; });
        EXPECT_THAT(loadingError(), HasSubstr(damage.second)) << pointer;
    }
    changeManifestOf(paintedProject(), "/arrays/painting~1points.f64", [](Json& count) { count = 7; });
    EXPECT_THAT(loadingError(), HasSubstr("painting/points.f64"));
}

TEST_F(ProjectFile, ARimThatIsNoneIsRefusedByItsName) {
    const std::vector<std::pair<Json, const char*>> cases{{-0.1, "region 2"}, {"wide", "rim"}};
    for (const auto& [rim, named] : cases) {
        changeManifest("/regions/1", [&rim = rim](Json& region) { region["rim"] = rim; });
        EXPECT_THAT(loadingError(), HasSubstr(named)) << rim;
    }
}

TEST_F(ProjectFile, AnyWrongValueIsRefusedByItsName) {
    const Json deep = Json::parse(std::string(90, '[') + std::string(90, ']'));
    const std::vector<ProjectDamage> cases{
        {"/format", "esm-projekt", "not a project"},
        {"/version", "1", "version"},
        {"/version", 0, "version"},
        {"/name", nullptr, "name"},
        {"/name", 7, "name"},
        {"/base", Json::array(), "base"},
        {"/base/mass", "heavy", "mass"},
        {"/base/mass", -1, "mass"},
        {"/base/springConstant", nullptr, "springConstant"},
        {"/regions", Json::object(), "regions"},
        {"/regions/0", 3, "regions"},
        {"/regions/0/fuzzySystem", 1, "fuzzySystem"},
        {"/regions/0/fuzzySystem", -1, "fuzzySystem"},
        {"/regions/0/colour", {1, 2}, "colour"},
        {"/regions/0/colour/0", 256, "colour"},
        {"/regions/0/inputs/0/value", "much", "inputs"},
        {"/regions/0/inputs/0/variable", "unheard-of", "unheard-of"},
        {"/regions/1/ellipsoid/radii", {0.1, 0.1}, "radii"},
        {"/regions/1/ellipsoid/radii", {0.1, 0.1, -0.1}, "region 2"},
        {"/regions/1/ellipsoid/orientation", {0, 0, 0, 0}, "region 2"},
        {"/regions/1/ellipsoid/centre", deep, "centre"},
        {"/fuzzySystems", Json::array(), "fuzzy system"},
        {"/fuzzySystems/0", Json::object(), "fuzzySystems"},
        {"/scene", 1, "scene"},
        {"/scene/duration", "long", "duration"},
        {"/scene/fixed/0/nodes", {1, 100000}, "scene"},
        {"/stepping", 0.01, "stepping"},
        {"/stepping/integrator", 3, "stepping.integrator"},
        {"/stepping/integrator", "auto", "stepping: auto"},
        {"/stepping/integrator", "split", "stepping: split computes in double precision"},
        {"/stepping/timeStep", 0, "stepping: the time step"},
        {"/stepping/timeStep", nullptr, "stepping.timeStep"},
        {"/stepping/precision", "half", "stepping.precision"},
        {"/stepping/error", -0.1, "stepping: the error"},
        {"/stepping/wallPerSimulatedSecond", 0, "stepping: the wall time"},
        {"/photos/files/0/entry", "photos/none.png", "photos/none.png"},
        {"/photos/files/0/bytes", 17, "photos/0.PNG"},
        {"/photos/files/0/bytes", 1e18, "bytes"},
        {"/photos/layers/0/file", 2, "photo file 2"},
        {"/photos/layers/0/projector", nullptr, "projector"},
        {"/photos/layers/0/projector/pose", {1, 0, 0, 0}, "pose"},
        {"/photos/layers/1/opacity", 1.5, "above"},
        {"/photos/layers/1/visible", 1, "visible"},
        {"/texture/size", 1e9, "texture"},
        {"/texture/size", 1000000000, "texture"},
        {"/texture/pages", 65, "texture.pages"},
        {"/photos/layers/0/projector/width", 1e-308, "projector.width"},
        {"/texture/baseColour", "red", "baseColour"},
        {"/atlas/pages", 0, "atlas"},
        {"/atlas/gap", -1, "atlas"},
        {"/importReport/components", -3, "components"},
        {"/importReport/warnings/0", 1, "warnings"},
        {"/arrays", nullptr, "arrays"},
        {"/arrays/mesh~1vertices.f64", 3, "mesh/vertices.f64"},
        {"/arrays/mesh~1vertices.f64", 145, "mesh/vertices.f64"},
        {"/arrays/mesh~1triangles.u32", 3000000000000000000U, "mesh/triangles.u32"},
        {"/arrays/network~1springs.u32", 2, "network/springs.u32"},
        {"/arrays/atlas~1corners.f64", 6, "atlas/corners.f64"},
    };
    for (const ProjectDamage& damage : cases) {
        saveWithManifest(damage.pointer, damage.value);
        const std::string message = loadingError();
        EXPECT_THAT(message, testing::AllOf(HasSubstr("organ.esm: "), HasSubstr(damage.named)))
            << damage.pointer << " = " << damage.value;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

TEST_F(ProjectFile, DamagedArraysAndPhotosAreRefusedByTheirName) {
    const auto put = [](std::size_t place, auto value) {
        return [=](auto&, ZipEntry& entry) {
            Bytes bytes;
            appendLittleEndian(bytes, value);
            std::copy(bytes.begin(), bytes.end(), entry.content.begin() + static_cast<std::ptrdiff_t>(place));
        };
    };
    const auto expectRefused = [&](const char* entry, const auto& change, const char* named) {
        saveChanged(entry, change);
        EXPECT_THAT(loadingError(), testing::AllOf(HasSubstr("organ.esm: "), HasSubstr(named)));
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();
    expectRefused("mesh/vertices.f64", put(8, nan), "mesh/vertices.f64: number 1 is not finite");
    expectRefused("network/nodes.f64", put(0, infinite), "network/nodes.f64");
    expectRefused("network/rest-lengths.f64", put(0, -1.0), "spring");
    expectRefused("network/springs.u32", put(4, 4000000000U), "network/springs.u32: number 1 is 4000000000");
    expectRefused("network/vertex-nodes.u32", put(0, 48U), "network/vertex-nodes.u32");
    expectRefused("mesh/triangles.u32", put(0, 48U), "mesh/triangles.u32");
    expectRefused("atlas/pages.u32", put(0, 1U), "atlas/pages.u32");
    expectRefused("atlas/corners.f64", put(0, nan), "atlas/corners.f64");
    expectRefused("photos/0.PNG", put(30, 0U), "photos/0.PNG");
    expectRefused("photos/1", put(0, 0U), "photos/1");
    expectRefused(
        "mesh/vertices.f64", [](auto&, ZipEntry& entry) { entry.content.pop_back(); }, "mesh/vertices.f64");
    expectRefused(
        "mesh/vertices.f64", [](auto& entries, ZipEntry&) { entries.erase(entries.begin() + 1); },
        "mesh/vertices.f64 is missing");
    expectRefused(
        "manifest.json", [](auto&, ZipEntry& entry) { entry.content.pop_back(); }, "manifest.json");
    expectRefused(
        "manifest.json", [](auto&, ZipEntry& entry) { entry.content.assign(100000, '['); }, "nested");
}

TEST_F(ProjectFile, AnEntryThatInflatesWithoutEndIsNotUnpacked) {
    saveChanged("mesh/vertices.f64",
                [](auto&, ZipEntry& entry) { entry.content.assign(std::size_t{1} << 26, 0); });
    EXPECT_LT(std::filesystem::file_size(m_file), 1U << 20);
    EXPECT_THAT(loadingError(), HasSubstr("mesh/vertices.f64 is larger than"));
}

TEST_F(ProjectFile, WhatRefersToADamagedArrayIsNoFurtherProblem) {
    for (const char* damaged :
         {"mesh/vertices.f64", "network/nodes.f64", "network/springs.u32", "network/rest-lengths.f64"}) {
        saveChanged(damaged, [](auto&, ZipEntry& entry) { entry.content.pop_back(); });
        EXPECT_THAT(validateProjectFile(m_file), testing::ElementsAre(HasSubstr(damaged)));
    }
}

TEST_F(ProjectFile, AMissingSceneIsOneProblem) {
    saveChanged(project_layout::manifest, [](auto&, ZipEntry& entry) {
        Json manifest = Json::parse(entry.content.begin(), entry.content.end());
        manifest.erase("scene");
        const std::string text = manifest.dump();
        entry.content.assign(text.begin(), text.end());
    });
    EXPECT_THAT(validateProjectFile(m_file), testing::ElementsAre(HasSubstr("scene")));
}

TEST_F(ProjectFile, ValidationFindsAllProblemsAtOnce) {
    saveChanged(project_layout::manifest, [](auto& entries, ZipEntry& entry) {
        Json manifest = Json::parse(entry.content.begin(), entry.content.end());
        manifest["base"]["mass"] = "heavy";
        manifest["regions"][1]["ellipsoid"].erase("radii");
        manifest["photos"]["layers"][0]["file"] = 9;
        const std::string text = manifest.dump();
        entry.content.assign(text.begin(), text.end());
        entries[1].content.pop_back();
    });
    const std::string problems = testing::PrintToString(validateProjectFile(m_file));
    for (const char* named : {"mesh/vertices.f64", "mass", "radii", "photo file 9"})
        EXPECT_THAT(problems, HasSubstr(named));
}

} // namespace
} // namespace esm
