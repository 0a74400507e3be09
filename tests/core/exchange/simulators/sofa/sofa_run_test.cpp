#include "core/exchange/simulators/sofa/sofa_run.h"

#include "core/samples/samples.h"
#include "core/support/errors.h"
#include "tests/support/full_disk.h"
#include "tests/support/running_process.h"
#include "tests/support/stand_in_sofa.h"
#include "tests/support/steady_progress.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <sys/wait.h>
#include <thread>

namespace esm {
namespace {

using test::WithVariable;
using testing::AllOf;
using testing::HasSubstr;

class SofaRuns : public testing::Test {
protected:
    SofaRun runAs(const std::string& role, const Progress& progress = {}) {
        const WithVariable named("SOFA_ROLE", role);
        HandoverMeans means;
        means.progress = progress;
        means.engine.timeStep = m_schedule.timeStep;
        return runInSofa(test::standInSofa(), m_handover, means, m_schedule);
    }
    std::string errorOf(const std::string& role) {
        try {
            runAs(role);
        } catch (const FileError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
        return "no error";
    }

    Handover m_handover = handoverOf(test::falling(makeSample("tube")));
    SofaSchedule m_schedule = sofaSchedule(0.1, 0.001);
};

TEST_F(SofaRuns, GiveEveryRecordFromTheStartOn) {
    const SofaRun run = runAs("right");
    ASSERT_EQ(run.states.size(), 21U);
    EXPECT_NEAR(run.states.back().time, 0.1, 1e-9);
    const auto& rest = m_handover.tissue.network->restPositions;
    ASSERT_EQ(run.states[0].positions.size(), rest.size());
    for (std::size_t node = 0; node < rest.size(); ++node) {
        EXPECT_LT((run.states[0].positions[node] - rest[node]).norm(), 1e-5);
        EXPECT_NEAR(run.states[20].positions[node].y() - rest[node].y(), -test::fallenBy, 1e-5);
    }
    EXPECT_NEAR(run.wallPerSimulatedSecond, 1.5 / 0.101, 1e-9) << "of one step more than are recorded";
}

TEST_F(SofaRuns, SayWhatSofaSaidWhereItFails) {
    EXPECT_THAT(errorOf("error"), AllOf(HasSubstr("ended with 1"), HasSubstr("no such component")));
    EXPECT_THAT(errorOf("silent"), AllOf(HasSubstr("wrote no motion"), HasSubstr("iterations done")));
    EXPECT_THAT(errorOf("short"), HasSubstr("wrote 9 of the 20"));
    EXPECT_THAT(errorOf("cut"), HasSubstr("wrote 19 of the 20"));
    EXPECT_THAT(errorOf("nan"), AllOf(HasSubstr("blew up"), testing::Not(HasSubstr("states.txt"))));
    EXPECT_THAT(errorOf("nodes"), HasSubstr("nodes where"));
}

TEST_F(SofaRuns, SayWhereThereIsNoProgram) {
    try {
        runInSofa("/nowhere/runSofa", m_handover, {}, m_schedule);
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("/nowhere/runSofa"));
    }
}

TEST_F(SofaRuns, CostAMessageWhereTheDiskIsFull) {
    EXPECT_TRUE(throwsOnFullDisk<FileError>(1000, [this] { runAs("right"); }));
}

TEST_F(SofaRuns, LeaveNoFileBehind) {
    const TemporaryFolder temporary;
    const WithVariable among("TMPDIR", temporary.path());
    runAs("right");
    errorOf("nan");
    EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
}

TEST_F(SofaRuns, TellHowFarTheyAreAndStopAnywhere) {
    test::expectGoodProgress([this](const Progress& progress) { runAs("right", progress); });
}

TEST_F(SofaRuns, EndSofaAndWhatItStartedWhereTheyAreCancelled) {
    const TemporaryFolder folder;
    const std::filesystem::path processes = folder / "processes";
    const WithVariable named("SOFA_PROCESSES", processes);
    pid_t sofa = 0, child = 0;
    const Progress stopOnceRunning = [&](double) {
        std::ifstream written(processes);
        return !(written >> sofa >> child);
    };
    EXPECT_THROW(runAs("hang", stopOnceRunning), Cancelled);
    ASSERT_GT(child, 0);
    while (test::isRunning(child)) // its new parent hears of it soon
        std::this_thread::yield();
    EXPECT_FALSE(test::isRunning(sofa));
    EXPECT_TRUE(::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD);
}

TEST(SofaProgram, IsTheOneThatIsNamedOrOnThePath) {
    const TemporaryFolder folder;
    const auto onPath = folder / "runSofa";
    const std::string before = ::getenv("PATH");
    ::setenv("PATH", ("/nowhere:" + folder.path().string() + ":" + before).c_str(), 1);
    std::filesystem::copy_file(test::standInSofa(), onPath);
    EXPECT_EQ(installedSofa(), onPath);
    {
        const WithVariable named("ESM_RUNSOFA", test::standInSofa());
        EXPECT_EQ(installedSofa(), test::standInSofa());
    }
    {
        const WithVariable named("ESM_RUNSOFA", folder.path() / "none");
        EXPECT_EQ(installedSofa(), std::nullopt);
    }
    std::filesystem::permissions(onPath, std::filesystem::perms::owner_read);
    EXPECT_NE(installedSofa(), onPath);
    ::setenv("PATH", before.c_str(), 1);
}

TEST_F(SofaRuns, NameTheReleaseThatIsInstalledWhereItIsAnother) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(test::standInSofa(), folder / "runSofa-24.06.00");
    std::filesystem::create_symlink("runSofa-24.06.00", folder / "runSofa");
    EXPECT_EQ(releaseOfProgram(folder / "runSofa"), SofaVersion::June2024);
    EXPECT_EQ(releaseOfProgram(test::standInSofa()), std::nullopt);
    EXPECT_EQ(releaseOfProgram(folder / "none"), std::nullopt);
    HandoverMeans means;
    means.engine.timeStep = m_schedule.timeStep;
    try {
        runInSofa(folder / "runSofa", m_handover, means, m_schedule);
        FAIL();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), AllOf(HasSubstr("for 26.06"), HasSubstr("is of release 24.06")));
    }
    means.engine.sofaVersion = SofaVersion::June2024;
    EXPECT_EQ(runInSofa(folder / "runSofa", m_handover, means, m_schedule).states.size(), 21U);
}

TEST(SofaSchedule, HasSomeTwentyRecordsAtEndsOfSteps) {
    for (const auto& [duration, step] :
         {std::pair{0.5, 0.005}, {1.0, 0.003}, {0.1, 0.05}, {0.001, 0.005}, {2.0, 1e-6}}) {
        const SofaSchedule schedule = sofaSchedule(duration, step);
        SCOPED_TRACE(duration);
        EXPECT_GE(schedule.records, 1U);
        EXPECT_LT(schedule.records, 40U);
        if (duration > 20 * step) {
            EXPECT_GE(schedule.records, 20U);
        }
        EXPECT_LE(std::abs(schedule.duration() - duration), std::max(step, schedule.every()));
    }
    EXPECT_EQ(sofaSchedule(0.5, 0.005).records, 20U);
    EXPECT_THROW(sofaSchedule(1e6, 1e-9), InvalidModel);
}

} // namespace
} // namespace esm
