#include "core/exchange/simulators/exporters.h"

#include "tests/core/exchange/kept_file.h"
#include "tests/support/exchange_projects.h"

namespace esm {
namespace {

using ExportersProgress = KeptFile;

/// A file is replaced; a folder comes to stand beside it, once what an earlier export left is gone.
std::filesystem::path targetBeside(const Exporter& exporter, const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path() / "organ";
    std::filesystem::remove_all(folder);
    return exporter.isFolder ? folder : file;
}

TEST_F(ExportersProgress, OfExportingIsSteadyAndStoppedItLeavesTheOldFile) {
    for (const Exporter& exporter : exporters())
        for (Project project : {paintedProject(), boundProject({Detail::Kind::Nodes, 40}), bareProject()}) {
            SetUp();
            targetBeside(exporter, file);
            expectGoodWriting([&](const Progress& progress) {
                exportProject(project, exporter, targetBeside(exporter, file), {progress, {}});
            });
        }
}

TEST_F(ExportersProgress, OfExportingIsSteadyWhereTheTextureIsPackedToo) {
    Project project = paintedProject();
    project.atlas = nullptr;
    for (const Exporter& exporter : exporters()) {
        SetUp();
        targetBeside(exporter, file);
        expectGoodWriting([&](const Progress& progress) {
            exportProject(project, exporter, targetBeside(exporter, file), {progress, {}});
        });
    }
}

} // namespace
} // namespace esm
