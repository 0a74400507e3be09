#include "app/editor/workers/latest_worker.h"

#include "core/support/errors.h"

#include <gtest/gtest.h>
#include <QSemaphore>

#include <new>
#include <vector>

using namespace esm;

namespace {

/// Doubles numbers when it is let, one at a time; odd ones are refused.
struct Doubling {
    QSemaphore begun, mayGoOn, told;
    std::vector<int> worked;
    bool looksUp = true; ///< whether it asks if it is to go on

    LatestWorker<int, int> worker{[this](const auto& task) {
                                      worked.push_back(task.question);
                                      begun.release();
                                      mayGoOn.acquire();
                                      if (looksUp && !task.progress()(0)) throw Cancelled();
                                      if (task.question % 2 != 0) throw InvalidModel("it is odd");
                                      return 2 * task.question;
                                  },
                                  [this] { told.release(); }};

    void finish() {
        mayGoOn.release();
        told.acquire();
    }
};

} // namespace

TEST(LatestWorker, Answers) {
    Doubling doubling;
    EXPECT_FALSE(doubling.worker.isWorking());
    EXPECT_EQ(doubling.worker.outcome().number, 0);
    EXPECT_EQ(doubling.worker.ask(4), 1);
    EXPECT_TRUE(doubling.worker.isWorking());
    doubling.finish();
    EXPECT_FALSE(doubling.worker.isWorking());
    EXPECT_EQ(doubling.worker.outcome().number, 1);
    EXPECT_EQ(doubling.worker.outcome().answer, 8);
}

TEST(LatestWorker, LeavesOutWhatANewerQuestionReplaces) {
    Doubling doubling;
    doubling.worker.ask(2);
    doubling.begun.acquire();
    doubling.worker.ask(4);
    EXPECT_EQ(doubling.worker.ask(6), 3);
    doubling.mayGoOn.release(); // the first gives up
    doubling.begun.acquire();
    doubling.finish();
    EXPECT_EQ(doubling.worked, (std::vector<int>{2, 6}));
    EXPECT_EQ(doubling.worker.outcome().number, 3);
    EXPECT_EQ(doubling.worker.outcome().answer, 12);
    EXPECT_FALSE(doubling.worker.isWorking());
}

TEST(LatestWorker, TellsWhyThereIsNoAnswerAndKeepsTheFormerOne) {
    Doubling doubling;
    doubling.worker.ask(4);
    doubling.finish();
    doubling.worker.ask(5);
    doubling.finish();
    EXPECT_EQ(doubling.worker.outcome().number, 2);
    EXPECT_EQ(doubling.worker.outcome().failure, "it is odd");
    EXPECT_EQ(doubling.worker.outcome().answer, 8);
    doubling.worker.ask(6);
    doubling.finish();
    EXPECT_EQ(doubling.worker.outcome().failure, "");
}

TEST(LatestWorker, TellsInTheUsersWordsThatMemoryIsShort) {
    QSemaphore told;
    LatestWorker<int, int> worker([](const auto&) -> int { throw std::bad_alloc(); },
                                  [&] { told.release(); });
    worker.ask(1);
    told.acquire();
    EXPECT_EQ(worker.outcome().failure, "there is not enough memory for it");
}

TEST(LatestWorker, LetsWorkGoOnThatNewQuestionsMayWaitFor) {
    Doubling doubling;
    doubling.looksUp = false;
    doubling.worker.ask(2);
    doubling.begun.acquire();
    doubling.worker.ask(4);
    doubling.finish();
    EXPECT_EQ(doubling.worker.outcome().answer, 4);
    EXPECT_TRUE(doubling.worker.isWorking());
    doubling.finish();
    EXPECT_EQ(doubling.worker.outcome().answer, 8);
}

TEST(LatestWorker, ShowsWhatItKnowsBeforeItIsDone) {
    QSemaphore told, mayEnd;
    LatestWorker<int, int> worker(
        [&](const auto& task) {
            task.show(task.question + 1);
            mayEnd.acquire();
            return task.question + 2;
        },
        [&] { told.release(); });
    worker.ask(10);
    told.acquire();
    EXPECT_EQ(worker.outcome().answer, 11);
    EXPECT_EQ(worker.outcome().number, 0) << "not answered yet";
    mayEnd.release();
    told.acquire();
    EXPECT_EQ(worker.outcome().answer, 12);
    EXPECT_EQ(worker.outcome().number, 1);
}

TEST(LatestWorker, GivesUpWhenItIsNeededNoMore) {
    QSemaphore begun;
    bool gaveUp = false;
    {
        LatestWorker<int, int> worker(
            [&](const auto& task) {
                begun.release();
                while (task.progress()(0))
                    QThread::yieldCurrentThread();
                gaveUp = true;
                throw Cancelled();
                return 0;
            },
            [] {});
        worker.ask(1);
        begun.acquire();
    }
    EXPECT_TRUE(gaveUp);
}
