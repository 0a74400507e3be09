#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/project/project.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"

#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace esm {

/// Composes the layers into the atlas on a thread of its own, of a surface and atlas that stay only what
/// changed. A project that comes while it works waits; only the latest is kept. Another mesh or atlas stops
/// the work at once.
class TextureComposer : public QObject {
    Q_OBJECT

public:
    using Pages = std::shared_ptr<const std::vector<Image>>;

    explicit TextureComposer(QObject* parent = nullptr);

    void compose(const Project& project) { m_worker.ask(project); }

    /// Whether a composition is under way or waits.
    bool isWorking() const { return m_worker.isWorking(); }
    Pages pages() const;                                      ///< null while nothing is composed
    std::shared_ptr<const SmallerPages> smallerPages() const; ///< of those pages
    std::shared_ptr<const Atlas> atlas() const;               ///< the one the pages belong to
    double milliseconds() const;                              ///< the last composition took
    std::string failure() const; ///< why it could not be composed; empty when all is well

signals:
    void composed();

private:
    struct Composed {
        std::shared_ptr<const Atlas> atlas;
        Pages pages;
        std::shared_ptr<const SmallerPages> smallerPages;
        double milliseconds = 0;
    };
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
    Composed result() const;

    Kept m_kept;
    Worker m_worker;
};

} // namespace esm
