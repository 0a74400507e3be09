#include "core/exchange/simulators/exporters.h"

#include "core/support/errors.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <set>

namespace esm {
namespace {

TEST(Exporters, HaveNamesAndEndingsOfTheirOwn) {
    std::set<std::string> names, endings;
    for (const Exporter& exporter : exporters()) {
        EXPECT_TRUE(names.insert(exporter.name).second) << exporter.name;
        EXPECT_TRUE(endings.insert(exporter.ending).second) << exporter.ending;
        EXPECT_EQ(&exporterFor("a folder/organ" + exporter.ending), &exporter);
        EXPECT_FALSE(exporter.title.empty() || exporter.purpose.empty()) << exporter.name;
    }
}

TEST(Exporters, AreFoundByTheEndingOfAFile) {
    EXPECT_EQ(exporterFor("organ.VTP").name, "vtp");
    EXPECT_EQ(exporterFor("folder.glb/Organ.Vtp").name, "vtp");
    EXPECT_EQ(exporterFor("organ.v2.GLB").name, "glb");
    EXPECT_EQ(exporterFor(".vtp").name, "vtp");
    EXPECT_EQ(&exporterFor("folder.vtp/organ"), &exporters().front());
    try {
        exporterFor("organ.stl");
        ADD_FAILURE() << "it would be a file of another kind than its name says";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("organ.stl: "));
        EXPECT_THAT(error.what(), testing::HasSubstr(".glb or .vtp"));
    }
}

/// All that is told of a project before it is written in that format.
std::string toldOf(const Project& project, const std::string& file) {
    std::string text;
    for (const auto& [what, instead] : differencesOf(handoverOf(project), exporterFor(file)).list)
        text += what + "; " + instead + "\n";
    return text;
}

TEST(Exporters, TellWhatAFormatLeavesOut) {
    EXPECT_THAT(toldOf(filledProject(), "a.vtp"), testing::HasSubstr("no cells for tetrahedra"));
    EXPECT_EQ(toldOf(filledProject(), "a.vtu"), "");
    EXPECT_THAT(toldOf(richProject(), "a.vtu"), testing::HasSubstr("no texture"));
    for (const char* file : {"a.iv", "a.tables"}) {
        EXPECT_THAT(toldOf(shiningProject(), file), testing::HasSubstr("how wet and rough")) << file;
        EXPECT_EQ(toldOf(richProject(), file), "") << file;
    }
}

TEST(Exporters, RefuseAProjectWithProblemsAndLeaveNoFile) {
    const TemporaryFolder folder;
    Project project = bareProject();
    project.base.mass = -1;
    for (const Exporter& exporter : exporters()) {
        const std::filesystem::path file = folder / ("organ" + exporter.ending);
        try {
            exportProject(project, exporter, file);
            ADD_FAILURE() << exporter.name;
        } catch (const FileError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("was not exported: "));
            EXPECT_THAT(error.what(), testing::HasSubstr("mass"));
        }
        EXPECT_FALSE(std::filesystem::exists(file)) << exporter.name;
    }
}

} // namespace
} // namespace esm
