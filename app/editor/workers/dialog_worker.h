#pragma once

#include "app/editor/workers/latest_worker.h"

#include <QObject>

namespace esm {

/// Says that a worker has news.
class DialogNews : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

signals:
    void answered();
};

/// Works for a dialog on a thread of its own, again whenever that is asked for in another way.
template<typename Question, typename Answered> class DialogWorker : public DialogNews {
public:
    using Answer = std::shared_ptr<const Answered>;
    using Worker = LatestWorker<Question, Answer>;

    /// @param work called on the worker's thread
    /// @param settleTime within which a number that is stepped to comes to rest before anything is computed
    DialogWorker(typename Worker::Work work, std::chrono::milliseconds settleTime, QObject* parent)
        : DialogNews(parent),
          m_worker(std::make_unique<Worker>(
              std::move(work), [this] { emit answered(); }, WorkerHabits{0, settleTime})) {}

    void look(const Question& question) { m_worker->ask(question); }
    /// The latest; none before the first.
    Outcome<Answer> outcome() const { return m_worker->outcome(); }
    bool isWorking() const { return m_worker->isWorking(); }
    /// Ends the work, which may take a moment; on any thread. Nothing may be asked afterwards.
    void stop() { m_worker.reset(); }

private:
    std::unique_ptr<Worker> m_worker;
};

} // namespace esm
