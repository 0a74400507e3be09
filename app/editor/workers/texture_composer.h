#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/project/project.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace esm {

/// Composes the layers into the atlas on a thread of its own, of a surface and atlas that stay only what
/// changed. A project that comes while it works waits; only the latest is kept. Another mesh or atlas stops
/// the work at once, and so does an edit that is taken back: what lies there then is what is asked for.
class TextureComposer : public QObject {
    Q_OBJECT

public:
    using Pages = std::shared_ptr<const std::vector<Image>>;

    /// What came of one composition.
    struct Composed {
        std::shared_ptr<const Atlas> atlas;               ///< the one the pages belong to
        Pages pages;                                      ///< null where nothing is composed
        std::shared_ptr<const SmallerPages> smallerPages; ///< of those pages
        double milliseconds = 0;                          ///< it took
        std::string failure; ///< why there is nothing composed; empty when all is well
    };

    explicit TextureComposer(QObject* parent = nullptr);

    void compose(const Project& project) { m_worker.ask(project); }

    /// Whether a composition is under way or waits.
    bool isWorking() const { return m_worker.isWorking(); }
    /// Of the composition under way, how much is done, 0 to 1.
    double progress() const { return m_progress; }
    /// The last. As one value: what is asked for later may be of the next.
    Composed composition() const;

signals:
    void composed();

private:
    /// What the thread keeps for the next composition.
    struct Kept {
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const Atlas> atlas;
        Composition composition;
        std::shared_ptr<const SmallerPages> smaller; ///< of the composition's pages
        CompositionCache cache;
    };
    using Worker = LatestWorker<Project, Composed>;

    Composed compositionOf(const Worker::Task& task);
    void keepPages(const Worker::Task& task);

    bool lies(const Project& project) const;

    Kept m_kept;
    std::atomic<double> m_progress = 0;
    Worker m_worker;
};

} // namespace esm
