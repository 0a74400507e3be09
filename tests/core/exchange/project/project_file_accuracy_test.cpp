#include "tests/core/exchange/project/project_file_fixture.h"

namespace esm {
namespace {

using AccuracyJson = nlohmann::ordered_json;

TEST_F(ProjectFile, LeavesOutMeasuredRunsOfIntegratorsThatItDoesNotKnowAndSaysSo) {
    changeManifest("/accuracy/runs/0/integrator", [](AccuracyJson& name) { name = "leapfrog"; });
    const OpenedProject opened = openProject(m_file);
    const Project original = richProject();
    const auto& all = original.accuracy->runs;
    ASSERT_TRUE(opened.project.accuracy);
    EXPECT_EQ(opened.project.accuracy->runs, std::vector<TradeoffRun>(all.begin() + 1, all.end()));
    ASSERT_FALSE(opened.warnings.empty());
    EXPECT_NE(opened.warnings.front().find("1 of the measured runs"), std::string::npos);
}

TEST_F(ProjectFile, NamesTheMeasuredRunThatIsFaulty) {
    changeManifest("/accuracy/runs/0/error", [](AccuracyJson& error) { error = -1; });
    EXPECT_NE(loadingError().find("run 1"), std::string::npos) << loadingError();
    changeManifest("/accuracy/runs/1/timeStep", [](AccuracyJson& step) { step = "long"; });
    EXPECT_NE(loadingError().find("accuracy.runs[1].timeStep"), std::string::npos) << loadingError();
    changeManifest("/accuracy/tissue", [](AccuracyJson& tissue) { tissue = "liver"; });
    EXPECT_NE(loadingError().find("16 hexadecimal digits"), std::string::npos) << loadingError();
    changeManifest("/accuracy", [](AccuracyJson& accuracy) { accuracy = 7; });
    EXPECT_NE(loadingError().find("accuracy"), std::string::npos) << loadingError();
}

} // namespace
} // namespace esm
