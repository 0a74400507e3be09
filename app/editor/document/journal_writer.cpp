#include "app/editor/document/journal_writer.h"

#include "core/support/errors.h"

namespace esm {

namespace {

bool goesOn(const JournalTask& task) {
    const auto* edit = std::get_if<EditTask>(&task);
    return edit && edit->step.mergeKey.kind != EditKind::Alone;
}

} // namespace

bool replaces(const JournalTask& later, const JournalTask& earlier) {
    if (later.index() != earlier.index()) return false;
    if (std::holds_alternative<JournalView>(later)) return true;
    const auto *last = std::get_if<EditTask>(&later), *first = std::get_if<EditTask>(&earlier);
    return last && first && goesOn(later) && last->place == first->place &&
           last->step.mergeKey == first->step.mergeKey && last->step.gesture == first->step.gesture;
}

JournalWriter::JournalWriter(std::filesystem::path folder, std::function<void(const JournalNews&)> told,
                             JournalHabits habits)
    : m_store(std::move(folder), habits.bounds), m_told(std::move(told)), m_habits(std::move(habits)),
      m_thread([this] { writeAll(); }) {}

JournalWriter::~JournalWriter() {
    {
        const std::lock_guard lock(m_mutex);
        m_isStopped = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

std::uint64_t JournalWriter::put(JournalTask task) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(m_mutex);
        if (!m_waiting.empty() && replaces(task, m_waiting.back())) m_waiting.pop_back();
        m_waiting.push_back(std::move(task));
        number = ++m_put;
    }
    m_changed.notify_all();
    return number;
}

void JournalWriter::finish() {
    std::unique_lock lock(m_mutex);
    ++m_hurried;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return m_waiting.empty() && !m_isWriting; });
    --m_hurried;
}

/// Whether all that waits is a drag's edit that others may replace yet.
bool JournalWriter::mayWait() const {
    return m_waiting.size() == 1 && goesOn(m_waiting.front()) && !m_isStopped && m_hurried == 0;
}

/// Empty when the writer is to end.
JournalWriter::Batch JournalWriter::take() {
    std::unique_lock lock(m_mutex);
    m_isWriting = false;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return !m_waiting.empty() || m_isStopped; });
    m_changed.wait_for(lock, m_habits.dragPause, [this] { return !mayWait(); });
    m_isWriting = true;
    return {std::exchange(m_waiting, {}), m_put};
}

void JournalWriter::writeAll() {
    for (Batch batch = take(); !batch.tasks.empty(); batch = take())
        write(batch);
}

void JournalWriter::write(const Batch& batch) {
    if (m_habits.begins) m_habits.begins(batch.last);
    for (const JournalTask& task : batch.tasks)
        attempt([&] { write(task); });
    if (!m_isBroken) attempt([&] { m_store.sync(); });
    if (m_isBroken) return;
    letGoOfTaken();
    if (m_habits.synced) m_habits.synced(batch.last);
    if (m_store.hasOutgrown()) m_told({JournalNews::Outgrown, {}});
}

void JournalWriter::letGoOfTaken() {
    if (m_taken) discard(*m_taken);
    m_taken.reset();
}

void JournalWriter::end() {
    m_isBroken = true;
    m_store.end();
    letGoOfTaken();
}

void JournalWriter::attempt(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        fail(reasonOf(error));
    }
}

void JournalWriter::fail(const std::string& reason) {
    m_isBroken = true;
    m_store.giveUp();
    m_told({JournalNews::Failed, reason});
}

void JournalWriter::write(const JournalTask& task) {
    if (const auto* begin = std::get_if<BeginTask>(&task)) {
        m_isBroken = true;
        m_store.begin(begin->state, begin->view);
        m_isBroken = false;
        return m_told({JournalNews::Begun, {}});
    }
    if (std::holds_alternative<EndTask>(task)) return end();
    if (const auto* taken = std::get_if<TakeOverTask>(&task)) m_taken = taken->left;
    if (m_isBroken) return;
    if (const auto* edit = std::get_if<EditTask>(&task))
        m_store.addEdit({edit->place, edit->step.text.toStdString(), edit->step.systemOf}, *edit->after);
    else if (const auto* move = std::get_if<MoveTask>(&task))
        m_store.addMove(move->place, move->last);
    else if (const auto* file = std::get_if<JournalFile>(&task))
        m_store.add(fileRecord(*file));
    else if (const auto* view = std::get_if<JournalView>(&task))
        m_store.add(viewRecord(*view));
}

} // namespace esm
