#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/zip_archive.h"
#include "tests/core/exchange/fields_set_in_none.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <zip.h>

#include <memory>
#include <set>

namespace esm {
namespace {

using ManifestJson = nlohmann::ordered_json;

/// What an archive holds, in its order.
std::vector<std::string> entryNames(const std::filesystem::path& file) {
    const std::unique_ptr<zip_t, decltype(&zip_discard)> archive(zip_open(file.c_str(), ZIP_RDONLY, nullptr),
                                                                 &zip_discard);
    std::vector<std::string> names;
    for (zip_int64_t i = 0; archive && i < zip_get_num_entries(archive.get(), 0); ++i)
        names.emplace_back(zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0));
    return names;
}

ManifestJson manifestWithoutProgram(const ZipReader& archive) {
    const Bytes text = archive.read(project_layout::manifest, 1 << 20);
    ManifestJson manifest = ManifestJson::parse(text.begin(), text.end());
    EXPECT_EQ(manifest.erase("program"), 1U);
    return manifest;
}

/// Every entry byte for byte, the manifest value by value, the version of the program left out.
void expectSameArchive(const std::filesystem::path& before, const std::filesystem::path& after) {
    ASSERT_EQ(entryNames(before), entryNames(after));
    const Bytes old = readFile(before), fresh = readFile(after);
    const ZipReader oldArchive(old), freshArchive(fresh);
    for (const std::string& entry : entryNames(before))
        if (entry != project_layout::manifest) {
            EXPECT_TRUE(oldArchive.read(entry, 1 << 20) == freshArchive.read(entry, 1 << 20)) << entry;
        }
    const ManifestJson a = manifestWithoutProgram(oldArchive), b = manifestWithoutProgram(freshArchive);
    EXPECT_EQ(ManifestJson::diff(a, b), ManifestJson::array());
    EXPECT_TRUE(a.dump() == b.dump()) << "the order of keys differs, or the sign of a 0";
}

int writtenVersionOf(const std::filesystem::path& project) {
    const Bytes content = readFile(project);
    return manifestWithoutProgram(ZipReader(content))["version"].get<int>();
}

TEST(ProjectFileSamples, AreOfEveryVersion) {
    std::set<int> versions;
    for (const std::filesystem::path& file : samples("projects"))
        versions.insert(writtenVersionOf(file));
    for (int version = 1; version <= projectFileVersion; ++version)
        EXPECT_EQ(versions.count(version), 1U) << version;
}

TEST(ProjectFileSamples, SetEveryField) {
    std::vector<BaseTissue> bases;
    std::vector<Region> regions;
    std::vector<TextureLayer> layers;
    std::vector<PhotoPreparation> preparations;
    std::vector<TextureSettings> textures;
    for (const std::filesystem::path& file : samples("projects")) {
        const Project project = loadProject(file);
        bases.push_back(project.base);
        textures.push_back(project.texture);
        regions.insert(regions.end(), project.regions.begin(), project.regions.end());
        layers.insert(layers.end(), project.layers.begin(), project.layers.end());
        for (const TextureLayer& layer : project.layers)
            preparations.push_back(layer.preparation);
    }
    EXPECT_THAT(fieldsSetInNone(bases), testing::IsEmpty());
    EXPECT_THAT(fieldsSetInNone(regions), testing::IsEmpty());
    EXPECT_THAT(fieldsSetInNone(layers), testing::IsEmpty());
    EXPECT_THAT(fieldsSetInNone(preparations), testing::IsEmpty());
    EXPECT_THAT(fieldsSetInNone(textures), testing::IsEmpty());
}

TEST(ProjectFileSamples, AreOfEveryKindOfLattice) {
    std::set<LatticeKind> kinds;
    for (const std::filesystem::path& file : samples("projects"))
        if (const Project project = loadProject(file); project.network->lattice)
            kinds.insert(project.network->lattice->filling.kind);
    for (const auto& [kind, word] : wordsOf<LatticeKind>)
        EXPECT_EQ(kinds.count(kind), 1U) << word;
}

TEST(ProjectFileSamples, AreSavedAsTheyWere) {
    const TemporaryFolder folder;
    for (const std::filesystem::path& file : samples("projects")) {
        SCOPED_TRACE(file.filename());
        EXPECT_THAT(validateProjectFile(file), testing::IsEmpty());
        const std::filesystem::path again = folder / "again.esm";
        saveProject(loadProject(file), again);
        expectSameArchive(file, again);
    }
}

} // namespace
} // namespace esm
