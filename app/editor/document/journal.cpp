#include "app/editor/document/journal.h"

#include "app/editor/document/journal_writer.h"

#include <QStandardPaths>
#include <QUuid>

#include <algorithm>

namespace esm {

namespace {

std::filesystem::path newJournal(const std::filesystem::path& folder) {
    const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces) + journalEnding;
    return folder / name.toStdString();
}

} // namespace

std::filesystem::path recoveryFolder() {
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(data.toStdString()) / "recovery";
}

template<class Task> void Journal::put(Task task) {
    m_lastPut = m_writer->put(std::move(task));
}

Journal::Journal(Document& document, Selection& selection, std::filesystem::path folder, QObject* parent,
                 JournalHabits habits)
    : QObject(parent), m_document(document), m_selection(selection), m_folder(std::move(folder)) {
    m_retry.setInterval(habits.retryPause);
    m_retry.setSingleShot(true);
    // From the writer's thread to this one. The writer ends before this object does, and what is in the queue
    // then goes with it.
    const auto told = [this](const JournalNews& news) {
        QMetaObject::invokeMethod(
            this, [this, news] { hear(news); }, Qt::QueuedConnection);
    };
    m_writer = std::make_unique<JournalWriter>(newJournal(m_folder), told, std::move(habits));
    connect(&m_retry, &QTimer::timeout, this, &Journal::noteReplaced);
    connect(&document, &Document::replaced, this, &Journal::noteReplaced);
    connect(&document, &Document::stepped, this, &Journal::noteStep);
    connect(&document, &Document::titleChanged, this, &Journal::noteFile);
    connect(&selection, &Selection::changed, this, &Journal::noteView);
    noteView();
    noteReplaced();
}

Journal::~Journal() {
    put(EndTask());
}

void Journal::finish() {
    m_writer->finish();
}

void Journal::setWorkspace(const std::string& name) {
    m_view.workspace = name;
    if (m_isKept && !m_isBroken) put(m_view);
}

void Journal::takeOver(LeftBehind left) {
    if (!m_isKept) begin();
    put(TakeOverTask{std::move(left)});
}

std::vector<Journal::Step> Journal::steps() const {
    std::vector<Step> steps;
    const QUndoStack& stack = *m_document.undoStack();
    steps.reserve(static_cast<std::size_t>(stack.count()));
    for (int i = 0; i < stack.count(); ++i)
        steps.push_back(static_cast<const ProjectCommand*>(stack.command(i))->after());
    return steps;
}

/// With the place of the clean state as the journal counts.
JournalFile Journal::file() const {
    JournalFile file = journalFile(m_document.file());
    if (file.clean) *file.clean += m_dropped;
    return file;
}

void Journal::noteReplaced() {
    if (m_document.isModified()) return begin();
    end();
    tellFailure({});
}

void Journal::begin() {
    m_isKept = true;
    m_isBroken = false;
    m_dropped = 0;
    m_steps = steps();
    m_file = file();
    put(BeginTask{m_document.state(), m_view});
}

void Journal::end() {
    m_retry.stop();
    if (m_isKept) put(EndTask());
    m_isKept = false;
    m_isBroken = false;
}

void Journal::noteStep() {
    if (m_isBroken) return;
    if (!m_isKept) return noteReplaced();
    const std::vector<Step> before = std::exchange(m_steps, steps());
    const int index = m_document.undoStack()->index();
    // A full undo list loses its first step to a new one.
    const bool isFull = before.size() == m_steps.size() && m_steps.size() > 1 && before[0] != m_steps[0];
    if (isFull && before[1] == m_steps[0]) ++m_dropped;
    const auto known = [&](const Step& step) {
        return std::find(before.begin(), before.end(), step) != before.end();
    };
    if (index > 0 && !known(m_steps[static_cast<std::size_t>(index) - 1])) return noteEdit(index);
    put(MoveTask{m_dropped + static_cast<std::uint64_t>(index), m_dropped + m_steps.size()});
}

void Journal::noteEdit(int index) {
    const auto& command = static_cast<const ProjectCommand&>(*m_document.undoStack()->command(index - 1));
    put(EditTask{m_dropped + static_cast<std::uint64_t>(index), command.step(), command.after()});
}

void Journal::noteFile() {
    if (!m_isKept || m_isBroken) {
        if (m_isBroken && !m_document.isModified()) tellFailure({});
        return;
    }
    if (JournalFile now = file(); now != m_file) {
        m_file = now;
        put(std::move(now));
    }
}

void Journal::noteView() {
    m_view.region = m_selection.region();
    m_view.photo = m_selection.photo();
    if (m_isKept && !m_isBroken) put(m_view);
}

void Journal::hear(const JournalNews& news) {
    if (!m_isKept) return;
    switch (news.kind) {
    case JournalNews::Begun:
        return noteBegun();
    case JournalNews::Outgrown:
        return noteOutgrown();
    case JournalNews::Failed:
        return noteFailure(QString::fromStdString(news.reason));
    }
}

void Journal::noteOutgrown() {
    if (!m_isRenewed && !m_isBroken) begin();
    m_isRenewed = true;
}

void Journal::noteFailure(const QString& reason) {
    if (!m_document.isModified()) return noteReplaced();
    m_isBroken = true;
    m_isRenewed = false;
    m_retry.start();
    tellFailure(reason);
}

void Journal::noteBegun() {
    m_isRenewed = false;
    // A failure of before was heard since this beginning was asked for, and steps were left out.
    if (m_isBroken) {
        m_retry.stop();
        return begin();
    }
    if (m_failure.isEmpty()) return;
    tellFailure({});
    emit message(tr("Unsaved work is kept again"));
}

void Journal::tellFailure(const QString& reason) {
    if (reason == m_failure) return;
    m_failure = reason;
    emit failed(reason);
}

} // namespace esm
