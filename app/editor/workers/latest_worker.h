#pragma once

#include "core/support/errors.h"
#include "core/support/latest_input.h"
#include "core/support/progress.h"
#include "core/support/thread_priority.h"

#include <QThread>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace esm {

/// What a worker has come to.
template<typename Answer> struct Outcome {
    int number = 0; ///< of the question that was answered last, or could not be, from 1
    Answer answer{};
    std::string failure; ///< why that question has no answer, which is still a former one's; empty when all
                         ///< is well
};

/// How a worker does its work.
struct WorkerHabits {
    int niceness = 0;                        ///< see giveWay()
    std::chrono::milliseconds settleTime{0}; ///< questions that follow each other faster are answered once
};

/// Answers questions on a thread of its own. The newest question wins: one that comes while it works makes
/// the one it works on obsolete, which the work is told by its progress, and none but the newest waits.
template<typename Question, typename Answer> class LatestWorker {
public:
    /// One question, as the work sees it.
    class Task {
    public:
        const Question& question;
        const int number; ///< from 1

        /// For work that asks whether to go on; false once the question is obsolete.
        Progress progress() const {
            return [this](double) { return !m_worker.m_questions.isObsolete(); };
        }
        /// The same, where some questions may wait until this one is answered.
        /// @param replaces whether the question that waits makes this one obsolete
        template<typename Replaces> Progress progress(const Replaces& replaces) const {
            return [this, replaces](double) {
                return !m_worker.m_questions.isObsolete(
                    [&](const Asked& next) { return replaces(next.question); });
            };
        }
        /// The answer as it is by now, which is told before the question is answered as a whole.
        void show(const Answer& answer) const {
            m_worker.store([&](Outcome<Answer>& outcome) { outcome.answer = answer; });
            m_worker.m_told();
        }

    private:
        friend class LatestWorker;
        Task(LatestWorker& worker, const Question& asked, int place)
            : question(asked), number(place), m_worker(worker) {}
        LatestWorker& m_worker;
    };

    /// What it throws is told as the reason why there is no answer; of Cancelled, for a question that became
    /// obsolete, nothing is told.
    using Work = std::function<Answer(const Task&)>;

    /// @param work called on the worker's thread
    /// @param told called on the worker's thread whenever there is news
    LatestWorker(Work work, std::function<void()> told, WorkerHabits habits = {})
        : m_work(std::move(work)), m_told(std::move(told)), m_habits(habits),
          m_thread(QThread::create([this] { answerAll(); })) {
        m_thread->start();
    }
    ~LatestWorker() {
        m_questions.stop();
        m_thread->wait();
    }
    LatestWorker(const LatestWorker&) = delete;
    LatestWorker& operator=(const LatestWorker&) = delete;

    /// Gives the question's number. To be called by one thread.
    int ask(Question question) {
        const int number = ++m_asked;
        m_questions.put({std::move(question), number});
        return number;
    }
    Outcome<Answer> outcome() const {
        const std::lock_guard lock(m_mutex);
        return m_outcome;
    }
    /// Whether a question waits or is being answered.
    bool isWorking() const { return m_answered != m_asked; }

private:
    struct Asked {
        Question question;
        int number;
    };

    template<typename Change> void store(const Change& change) {
        const std::lock_guard lock(m_mutex);
        change(m_outcome);
    }

    void answerAll() {
        giveWay(m_habits.niceness);
        while (const auto asked = m_questions.take())
            if (!m_questions.becomesObsoleteWithin(m_habits.settleTime)) answer(*asked);
    }

    void answer(const Asked& asked) {
        try {
            Answer answer = m_work(Task(*this, asked.question, asked.number));
            store([&](Outcome<Answer>& outcome) { outcome = {asked.number, std::move(answer), {}}; });
        } catch (const Cancelled&) {
            return; // another question waits
        } catch (const std::exception& error) {
            fail(asked.number, reasonOf(error));
        }
        m_answered = asked.number; // before anyone hears of it
        m_told();
    }

    void fail(int number, const std::string& reason) {
        store([&](Outcome<Answer>& outcome) {
            outcome.number = number;
            outcome.failure = reason;
        });
    }

    Work m_work;
    std::function<void()> m_told;
    WorkerHabits m_habits;
    LatestInput<Asked> m_questions;
    mutable std::mutex m_mutex; ///< guards the outcome
    Outcome<Answer> m_outcome;
    std::atomic<int> m_asked = 0, m_answered = 0; ///< numbers of questions
    std::unique_ptr<QThread> m_thread;
};

} // namespace esm
