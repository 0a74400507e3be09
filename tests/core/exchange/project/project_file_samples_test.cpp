#include "core/exchange/project/project_file.h"
#include "core/exchange/project/project_layout.h"
#include "core/exchange/project/zip_archive.h"
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
