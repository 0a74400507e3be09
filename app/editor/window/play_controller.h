#pragma once

#include "app/editor/workers/preview.h"

#include <QWidget>

namespace esm {

struct Actions;

/// Playing, pausing, going back to rest, and the gentle motion of an organ that was just opened.
class PlayController : public QObject {
    Q_OBJECT

public:
    PlayController(QWidget& window, Preview& preview);

    void connectActions(const Actions& actions);
    /// Shows a newly opened organ alive.
    void showAlive();
    /// The user took over.
    void endGentleMotion() { m_preview.setGentleMotion(false); }

private:
    Preview& m_preview;
};

} // namespace esm
