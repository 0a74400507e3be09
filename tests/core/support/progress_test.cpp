#include "core/support/shared_progress.h"
#include "tests/support/steady_progress.h"

#include <thread>

namespace esm {
namespace {

void inTenSteps(const Progress& progress) {
    for (int step = 0; step <= 10; ++step)
        reportProgress(progress, step / 10.0);
}

TEST(ProgressParts, LieOneBehindTheOther) {
    const std::vector<double> told = test::toldBy([](const Progress& progress) {
        ProgressParts parts(progress);
        reportProgress(parts.next(0.25), 1);
        reportProgress(parts.next(0.5), 0.5);
        reportProgress(parts.rest(), 1);
    });
    EXPECT_EQ(told, (std::vector<double>{0.25, 0.5, 1}));
}

TEST(ProgressParts, NeverGoBackHoweverManyThereAre) {
    test::expectGoodProgress([](const Progress& progress) {
        ProgressParts parts(progress);
        for (int part = 0; part < 20; ++part)
            inTenSteps(parts.nextOfRest(0.3));
        ProgressParts within(parts.rest());
        inTenSteps(within.next(0.5));
        inTenSteps(within.rest());
    });
}

TEST(ProgressParts, KeepToTheirShareWhateverAPartTells) {
    const std::vector<double> told = test::toldBy([](const Progress& progress) {
        ProgressParts parts(progress);
        reportProgress(parts.next(0.5), 7);
        reportProgress(parts.next(0.8), -3);
        reportProgress(parts.next(0.8), 1);
    });
    EXPECT_EQ(told, (std::vector<double>{0.5, 0.5, 1}));
}

TEST(ProgressParts, AreEmptyWhereNobodyListens) {
    ProgressParts parts({});
    EXPECT_FALSE(parts.next(0.5));
    EXPECT_FALSE(parts.rest());
}

TEST(SharedProgress, TellsWhatAllThreadsHaveDoneFromOne) {
    std::vector<double> told;
    const std::thread::id here = std::this_thread::get_id();
    const Progress progress = [&](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        told.push_back(fraction);
        return true;
    };
    SharedProgress shared(progress, 10);
    std::thread([&] { shared.add(4); }).join();
    shared.add();
    EXPECT_EQ(told, (std::vector<double>{0.5}));
}

TEST(SharedProgress, StopsOtherThreadsToo) {
    const Progress progress = [](double) { return false; };
    SharedProgress shared(progress, 10);
    std::thread([&] { EXPECT_NO_THROW(shared.add()); }).join();
    EXPECT_THROW(shared.add(), Cancelled);
    std::thread([&] { EXPECT_THROW(shared.add(), Cancelled); }).join();
}

} // namespace
} // namespace esm
