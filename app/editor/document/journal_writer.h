#pragma once

#include "app/editor/document/edit_kind.h"
#include "app/editor/document/journal_store.h"
#include "app/editor/document/left_behind.h"
#include "app/editor/document/project_command.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <variant>

namespace esm {

// What is to be written.
struct BeginTask {
    DocumentState state;
    JournalView view;
};
struct EditTask {
    std::uint64_t place;
    EditStep step;
    std::shared_ptr<const Project> after;
};
struct MoveTask {
    std::uint64_t place, last;
};
/// What was left behind goes once the journal has all of it.
struct TakeOverTask {
    LeftBehind left;
};
struct EndTask {};
using JournalTask =
    std::variant<BeginTask, EditTask, MoveTask, JournalFile, JournalView, TakeOverTask, EndTask>;

/// What the writer has to tell.
struct JournalNews {
    enum Kind { Begun, Outgrown, Failed } kind;
    std::string reason; ///< of the failure
};

/// Writes a journal on a thread of its own, task by task. An edit that becomes one step with the one before
/// replaces it while nobody has begun to write that. After a failure nothing is written before a `BeginTask`.
class JournalWriter {
public:
    /// @param told called on the writer's thread
    JournalWriter(std::filesystem::path folder, std::function<void(const JournalNews&)> told,
                  JournalHabits habits);
    /// Writes what is left.
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    /// Gives the task's number, from 1. Waits for nothing.
    std::uint64_t put(JournalTask task);
    /// Waits until all is written, without the pauses of a drag.
    void finish();

private:
    struct Batch {
        std::deque<JournalTask> tasks;
        std::uint64_t last; ///< number of the last task
    };
    Batch take();
    void writeAll();
    void write(const Batch& batch);
    void write(const JournalTask& task);
    void end();
    void letGoOfTaken();
    void attempt(const std::function<void()>& work);
    void fail(const std::string& reason);
    bool mayWait() const;

    JournalStore m_store;
    std::function<void(const JournalNews&)> m_told;
    JournalHabits m_habits;
    bool m_isBroken = true;            ///< nothing is written before a beginning
    std::optional<LeftBehind> m_taken; ///< not all of it is on the disk here yet

    std::mutex m_mutex; ///< guards what follows
    std::condition_variable m_changed;
    std::deque<JournalTask> m_waiting;
    std::uint64_t m_put = 0;
    bool m_isWriting = false, m_isStopped = false;
    int m_hurried = 0; ///< who waits for the end
    std::thread m_thread;
};

/// Whether a task makes the one before it, which is not written yet, needless.
bool replaces(const JournalTask& later, const JournalTask& earlier);

} // namespace esm
