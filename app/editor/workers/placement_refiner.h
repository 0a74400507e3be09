#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/texture/layers/pose_refinement.h"

#include <QObject>

#include <memory>

namespace esm {

/// A photo, and the layers that it shall agree with, from the lowest to the topmost.
struct PlacementQuestion {
    std::shared_ptr<const TriangleMesh> mesh;
    std::vector<TextureLayer> others;
    TextureLayer photo;
};

/// Moves photos to where they agree with others, on a thread of its own: it takes seconds on large organs.
class PlacementRefiner : public QObject {
    Q_OBJECT

public:
    explicit PlacementRefiner(QObject* parent = nullptr);

    void refine(PlacementQuestion question) { m_worker.ask(std::move(question)); }
    bool isWorking() const { return m_worker.isWorking(); }
    /// Nothing where no place near agrees better.
    std::optional<PoseRefinement> answer() const { return m_worker.outcome().answer; }

signals:
    void answered();

private:
    LatestWorker<PlacementQuestion, std::optional<PoseRefinement>> m_worker;
};

} // namespace esm
