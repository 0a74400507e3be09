#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/texture/projection/pose_fit.h"

#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace esm {

struct PoseQuestion {
    std::vector<LandmarkPair> pairs;
    PhotoCamera camera;

    bool operator==(const PoseQuestion&) const = default;
};

struct PoseAnswer {
    PoseQuestion question;
    std::optional<PoseFit> fit;
    std::string failure; ///< why there is no fit, in the core's words
};

/// Finds poses from landmarks on a thread of its own: many pairs take longer than a drag may wait. Only the
/// latest question is answered.
class PoseFinder : public QObject {
    Q_OBJECT

public:
    explicit PoseFinder(QObject* parent = nullptr);

    void find(PoseQuestion question) { m_worker.ask(std::move(question)); }
    /// The latest; null before the first.
    std::shared_ptr<const PoseAnswer> answer() const { return m_worker.outcome().answer; }

signals:
    void answered();

private:
    LatestWorker<PoseQuestion, std::shared_ptr<const PoseAnswer>> m_worker;
};

} // namespace esm
