#include "core/exchange/project/project_file.h"

#include "tests/core/exchange/kept_file.h"
#include "tests/support/exchange_projects.h"

namespace esm {
namespace {

using ProjectFileProgress = KeptFile;

TEST_F(ProjectFileProgress, OfSavingIsSteadyAndStoppedItLeavesTheOldFile) {
    for (const Project& project : {paintedProject(), richProject(40), bareProject()}) {
        SetUp();
        expectGoodWriting([&](const Progress& progress) { saveProject(project, file, progress); });
    }
}

TEST_F(ProjectFileProgress, OfOpeningIsSteady) {
    for (const Project& project : {paintedProject(), richProject(40), bareProject()}) {
        saveProject(project, file);
        test::expectGoodProgress([&](const Progress& progress) { openProject(file, progress); });
    }
}

} // namespace
} // namespace esm
