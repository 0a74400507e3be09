#pragma once

#include "app/editor/document/document.h"
#include "app/editor/window/passing_time.h"
#include "app/editor/workers/preview_run.h"
#include "widgets/view/view_notice.h"

#include <optional>

namespace esm {

/// As many nodes as this machine likely computes at real speed. A step's cost grows with the nodes, and a
/// little is left for what else is to be done.
/// @param realTimeFactor of the nodes that there are, below 1
std::size_t nodesAtRealSpeed(std::size_t nodes, double realTimeFactor);

/// Says in the view that the tissue moves slower than it is, and offers to simulate fewer nodes: who tunes
/// tissue that is slowed down tunes it wrongly.
class SlowMotion : public QObject {
    Q_OBJECT

public:
    SlowMotion(QWidget& view, Document& document, PassingTime clock = sinceStart());

    void showStatus(const PreviewStatus& status);

signals:
    void fewerNodesAsked(std::size_t nodes);

private:
    void forget();
    void noteSpeed(bool isSlow);
    void tell(double realTimeFactor);

    Document& m_document;
    PassingTime m_clock;
    ViewNotice* m_notice;
    std::optional<qint64> m_slowSince;  ///< ms, while the motion is too slow
    std::optional<qint64> m_rightSince; ///< ms, while it is not
    double m_said = 0;                  ///< of real speed
    std::size_t m_offered = 0;          ///< nodes
    bool m_isDismissed = false;         ///< until the organ or its nodes are others
};

} // namespace esm
