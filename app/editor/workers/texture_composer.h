#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/project/project.h"
#include "core/texture/layers/composite.h"
#include "core/texture/layers/page_levels.h"
#include "core/texture/maps/finish_pages.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace esm {

/// Composes the layers into the atlas on a thread of its own, of a surface and atlas that stay only what
/// changed. A project that comes while it works waits; only the latest is kept. Another mesh or atlas stops
/// the work at once, and so does an edit that is taken back: what lies there then is what is asked for.
class TextureComposer : public QObject {
    Q_OBJECT

public:
    using Pages = std::shared_ptr<const TiledPages>;

    /// What came of one composition.
    struct Composed {
        std::shared_ptr<const Atlas> atlas;               ///< the one the pages belong to
        Pages pages;                                      ///< null where nothing is composed
        std::shared_ptr<const SmallerPages> smallerPages; ///< of those pages
        Pages finishPages;                                ///< how they shine; null where layers do not say it
        double milliseconds = 0;                          ///< it took
        std::optional<LayerId> moving{}; ///< which is left out of the pages, as its photo moves
        bool isMasked = false;           ///< the pages' alpha is what strokes have left of that
        std::shared_ptr<const Image>
            bands{};           ///< added to that by bands, see `bandsInMotion`; null for nothing
        std::string failure{}; ///< why there is nothing composed; empty when all is well
    };

    explicit TextureComposer(QObject* parent = nullptr);

    /// @param moving a layer whose photo the renderer projects meanwhile
    void compose(const Project& project, std::optional<LayerId> moving = std::nullopt);

    /// Whether a composition is under way or waits.
    bool isWorking() const { return m_worker.isWorking(); }
    /// Of the composition under way, how much is done, 0 to 1.
    double progress() const { return m_progress; }
    /// The last. As one value: what is asked for later may be of the next.
    Composed composition() const;

signals:
    void composed();

private:
    /// Pages with what strokes leave of a moving photo.
    struct MaskedPages {
        Pages of; ///< null for none
        BrushStrokes strokes;
        Pages pages;
        std::shared_ptr<const SmallerPages> smaller;
    };
    /// What the thread keeps for the next composition.
    struct Kept {
        std::shared_ptr<const TriangleMesh> mesh;
        std::shared_ptr<const Atlas> atlas;
        Composition composition;
        std::shared_ptr<const SmallerPages> smaller; ///< of the composition's pages
        MaskedPages masked;
        CompositionCache cache;
        // Of the finish, whose layers are others.
        std::optional<SurfaceFinish> base;
        FinishComposition finish;
        FinishPictures finishPictures;
        CompositionCache finishCache;
    };
    struct Asked {
        Project project; ///< without the moving photo
        std::optional<TextureLayer> moving;
    };
    using Worker = LatestWorker<Asked, Composed>;

    Composed compositionOf(const Worker::Task& task);
    void keepPages(const Worker::Task& task);
    FinishComposition finishOf(const Project& project, const Progress& progress);
    /// Adds what the renderer needs to project the moving photo.
    void addMotion(const Worker::Task& task, Composed& composed);
    void mask(const Project& project, const BrushStrokes& strokes, Composed& composed);
    bool isKept(const Asked& asked) const;
    /// The smaller pages of what is composed now, from those of what is kept.
    std::shared_ptr<const SmallerPages> halved(const Project& project, const TiledPages& pages,
                                               const Progress& progress);

    bool lies(const Project& project) const;

    Kept m_kept;
    std::atomic<double> m_progress = 0;
    Worker m_worker;
};

} // namespace esm
