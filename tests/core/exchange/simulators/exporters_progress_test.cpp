#include "core/exchange/simulators/exporters.h"

#include "tests/core/exchange/kept_file.h"
#include "tests/support/exchange_projects.h"

namespace esm {
namespace {

using ExportersProgress = KeptFile;

TEST_F(ExportersProgress, OfExportingIsSteadyAndStoppedItLeavesTheOldFile) {
    for (const Exporter& exporter : exporters())
        for (Project project : {paintedProject(), boundProject({Detail::Kind::Nodes, 40}), bareProject()}) {
            SetUp();
            expectGoodWriting([&](const Progress& progress) {
                exportProject(project, exporter, file, {progress, {}});
            });
        }
}

TEST_F(ExportersProgress, OfExportingIsSteadyWhereTheTextureIsPackedToo) {
    Project project = paintedProject();
    project.atlas = nullptr;
    for (const Exporter& exporter : exporters()) {
        SetUp();
        expectGoodWriting([&](const Progress& progress) {
            exportProject(project, exporter, file, {progress, {}});
        });
    }
}

} // namespace
} // namespace esm
