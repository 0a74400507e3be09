#include "core/decoding/decoder_process.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/exchange/project/project_file.h"
#include "core/exchange/simulators/exporters.h"
#include "core/support/file_io.h"
#include "tests/support/exchange_projects.h"
#include "tests/support/steady_progress.h"
#include "tests/support/temporary_folder.h"

#include <fstream>

namespace esm {
namespace {

/// A folder with one file that work would replace.
class ExchangeProgress : public testing::Test {
protected:
    void SetUp() override { writeFileAtomically(file, before); }

    bool isUntouched() const {
        const std::filesystem::directory_iterator all(folder.path());
        return std::distance(all, {}) == 1 && readFile(file) == before;
    }
    void expectGoodWriting(const test::LongWork& write) const {
        test::expectStopsAnywhere(write, [this] { return isUntouched(); });
        test::expectSteadyProgress(write);
        EXPECT_FALSE(isUntouched());
    }

    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "before";
    const Bytes before{1, 2, 3};
};

TEST_F(ExchangeProgress, OfSavingIsSteadyAndStoppedItLeavesTheOldFile) {
    for (const Project& project : {paintedProject(), richProject(40), bareProject()}) {
        SetUp();
        expectGoodWriting([&](const Progress& progress) { saveProject(project, file, progress); });
    }
}

TEST_F(ExchangeProgress, OfExportingIsSteadyAndStoppedItLeavesTheOldFile) {
    for (const Exporter& exporter : exporters())
        for (Project project : {paintedProject(), boundProject({Detail::Kind::Nodes, 40}), bareProject()}) {
            SetUp();
            expectGoodWriting([&](const Progress& progress) {
                exportProject(project, exporter, file, {progress, {}});
            });
        }
}

TEST_F(ExchangeProgress, OfExportingIsSteadyWhereTheTextureIsPackedToo) {
    Project project = paintedProject();
    project.atlas = nullptr;
    for (const Exporter& exporter : exporters()) {
        SetUp();
        expectGoodWriting([&](const Progress& progress) {
            exportProject(project, exporter, file, {progress, {}});
        });
    }
}

TEST_F(ExchangeProgress, OfOpeningIsSteady) {
    for (const Project& project : {paintedProject(), richProject(40), bareProject()}) {
        saveProject(project, file);
        test::expectGoodProgress([&](const Progress& progress) { openProject(file, progress); });
    }
}

TEST_F(ExchangeProgress, OfReadingAMeshIsSteady) {
    const std::filesystem::path mesh = folder / "organ.obj";
    std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const std::vector<double> told =
        test::toldBy([&](const Progress& progress) { readMeshFile(mesh, progress); });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
    test::expectStopsAnywhere([&](const Progress& progress) { readMeshFile(mesh, progress); });
}

} // namespace
} // namespace esm
