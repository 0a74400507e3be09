#pragma once

#include "app/editor/workers/latest_input.h"
#include "core/project/project.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
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
    ~TextureComposer() override;

    void compose(const Project& project);

    /// Whether a composition is under way or waits.
    bool isWorking() const { return m_finished != m_asked; }
    Pages pages() const;                                      ///< null while nothing is composed
    std::shared_ptr<const SmallerPages> smallerPages() const; ///< of those pages
    std::shared_ptr<const Atlas> atlas() const;               ///< the one the pages belong to
    double milliseconds() const;                              ///< the last composition took
    std::string failure() const; ///< why it could not be composed; empty when all is well

signals:
    void composed();

private:
    struct Request {
        Project project;
        int number; ///< of the request, from 1
    };

    void work();
    void compose(const Request& request);
    Pages pagesOf(const Project& project);

    /// What the thread keeps for the next composition.
    struct Kept {
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const Atlas> atlas;
        Composition composition;
        std::shared_ptr<const SmallerPages> smaller; ///< of the composition's pages
        CompositionCache cache;
    };

    LatestInput<Request> m_requests;
    Kept m_kept;
    mutable std::mutex m_mutex; ///< guards the result
    std::shared_ptr<const Atlas> m_atlas;
    Pages m_pages;
    std::shared_ptr<const SmallerPages> m_smallerPages;
    double m_milliseconds = 0;
    std::string m_failure;
    std::atomic<int> m_asked = 0, m_finished = 0; ///< numbers of requests
    std::thread m_thread;
};

} // namespace esm
