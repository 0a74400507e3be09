#include "core/exchange/project_file.h"

#include "core/exchange/fuzzy_file.h"
#include "core/exchange/json_reader.h"
#include "core/exchange/project_layout.h"
#include "core/exchange/scene_file.h"
#include "core/exchange/zip_archive.h"
#include "core/support/byte_order.h"
#include "core/support/errors.h"
#include "tests/core/exchange/exchange_projects.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/full_disk.h"
#include "tests/support/same_project.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <opencv2/imgcodecs.hpp>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class ProjectFile : public testing::Test {
protected:
    std::string loadingError() const {
        try {
            loadProject(m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "loaded";
    }

    /// Saves the rich project with one entry of its archive changed.
    template<typename Change> void saveChanged(const std::string& name, const Change& change) const {
        saveProject(richProject(), m_file);
        const Bytes bytes = readFile(m_file);
        const ZipReader archive(bytes);
        const Bytes text = archive.read(project_layout::manifest, 1 << 20);
        const Json manifest = Json::parse(text.begin(), text.end());
        std::vector<ZipEntry> entries{{project_layout::manifest, text, true}};
        for (const auto& array : manifest["arrays"].items())
            entries.push_back({array.key(), archive.read(array.key(), 1 << 20), true});
        for (const Json& photo : manifest["photos"]["files"])
            entries.push_back({photo["entry"], archive.read(photo["entry"], 1 << 20), false});
        const auto entry =
            std::find_if(entries.begin(), entries.end(), [&](const ZipEntry& e) { return e.name == name; });
        ASSERT_NE(entry, entries.end()) << name;
        change(entries, *entry);
        overwrite(m_file, makeZip(entries));
    }

    /// The same with one value of the manifest changed.
    template<typename Change> void changeManifest(const std::string& pointer, const Change& change) const {
        saveChanged(project_layout::manifest, [&](auto&, ZipEntry& entry) {
            Json manifest = Json::parse(entry.content.begin(), entry.content.end());
            change(manifest.at(Json::json_pointer(pointer)));
            const std::string text = manifest.dump();
            entry.content.assign(text.begin(), text.end());
        });
    }

    void saveWithManifest(const std::string& pointer, const Json& value) const {
        changeManifest(pointer, [&](Json& old) { old = value; });
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.esm";
};

TEST_F(ProjectFile, ComesBackBitByBit) {
    const Project project = richProject();
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
}

TEST_F(ProjectFile, KeepsHowFewerNodesCarryTheSurface) {
    for (const Detail& detail : {Detail{Detail::Kind::Nodes, 20}, Detail{Detail::Kind::Rigid, 0}}) {
        const Project project = boundProject(detail);
        saveProject(project, m_file);
        expectSameProject(project, loadProject(m_file));
        EXPECT_THAT(validateProjectFile(m_file), testing::IsEmpty());
    }
}

TEST_F(ProjectFile, IsOfTheVersionThatProgramsNeedToReadIt) {
    const auto version = [&](const Project& project) {
        saveProject(project, m_file);
        const Bytes bytes = readFile(m_file), text = ZipReader(bytes).read(project_layout::manifest, 1 << 20);
        return Json::parse(text.begin(), text.end())["version"].get<int>();
    };
    EXPECT_EQ(version(richProject()), 1);
    EXPECT_EQ(version(boundProject({Detail::Kind::Nodes, 20})), 2);
}

TEST_F(ProjectFile, ABindingThatCannotCarryTheSurfaceIsNotSaved) {
    Project project = boundProject({Detail::Kind::Nodes, 20});
    SpringNetwork network = *project.network;
    network.binding->vertices.pop_back();
    project.network = std::make_shared<SpringNetwork>(network);
    EXPECT_THROW(saveProject(project, m_file), FileError);
}

TEST_F(ProjectFile, KeepsAModelWithoutSurfaceRegionsOrPhotos) {
    saveProject(bareProject(), m_file);
    expectSameProject(bareProject(), loadProject(m_file));
}

TEST_F(ProjectFile, SharesWhatWasShared) {
    saveProject(richProject(), m_file);
    const Project loaded = loadProject(m_file);
    EXPECT_EQ(loaded.regions[0].system, loaded.regions[1].system);
    EXPECT_EQ(loaded.photos[0].photo, loaded.photos[2].photo);
}

TEST_F(ProjectFile, KeysThatAreNotKnownAreIgnored) {
    for (const char* place : {"", "/fuzzySystems/0", "/fuzzySystems/0/inputs/zeal", "/regions/0", "/base"}) {
        changeManifest(place, [](Json& object) { object["newer"] = "unheard-of"; });
        EXPECT_EQ(loadingError(), "loaded") << place;
    }
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
    saveWithManifest("/version", 3);
    EXPECT_THAT(loadingError(),
                HasSubstr("organ.esm: was made by a newer version (3) of the program; this one reads "
                          "up to 2; update the program"));
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

TEST_F(ProjectFile, WhatCouldNotBeLoadedIsNotSaved) {
    for (const AtlasOptions& options :
         {AtlasOptions{20000, 1, 2}, {1024, 65, 2}, {16384, 5, 2}, {64, 1, 20000}}) {
        Project project = richProject();
        project.texture.atlas = options;
        EXPECT_THROW(saveProject(project, m_file), FileError) << options.size;
    }
    EXPECT_FALSE(std::filesystem::exists(m_file));
}

struct ProjectDamage {
    const char* pointer;
    Json value;
    const char* named; ///< what the message must name
};

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

TEST_F(ProjectFile, AProjectWithProblemsIsNotSavedOverAGoodOne) {
    saveProject(richProject(), m_file);
    const Bytes before = readFile(m_file);
    Project bad = richProject();
    bad.base.mass = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(saveProject(bad, m_file), FileError);
    bad = richProject();
    bad.photos[0].projector.pose.linear() *= 2;
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

TEST_F(ProjectFile, NamesThatAreNoUnicodeAreStillSaved) {
    Project project = richProject();
    project.name = "Leber \xe4";
    saveProject(project, m_file);
    EXPECT_EQ(loadProject(m_file).name, "Leber \xef\xbf\xbd");
}

} // namespace
} // namespace esm
