#pragma once

#include "app/editor/window/passing_time.h"

#include <QAction>
#include <QKeyEvent>

#include <optional>

namespace esm {

/// Makes a switch's key one to hold as well: a tap switches, and who keeps it down longer only has a look,
/// since it switches back when it comes up.
class PeekKey : public QObject {
    Q_OBJECT

public:
    explicit PeekKey(QAction& action, PassingTime clock = sinceStart());

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isOwn(const QKeyEvent& event) const;
    void release();

    QAction& m_action;
    PassingTime m_clock;
    std::optional<qint64> m_down; ///< ms, since when the key is down
    bool m_hasSwitched = false;   ///< with this press
};

} // namespace esm
