#pragma once

#include "app/editor/panels/measure/measure_column.h"
#include "app/editor/window/actions.h"
#include "app/editor/window/workspaces.h"

#include <QStackedWidget>

namespace esm {

/// The workspace Measure: speed and accuracy, the virtual test and the recorded poke, each with its panels at
/// the left, its chart below the organ and the tool that it needs.
class MeasureController : public QObject {
    Q_OBJECT

public:
    MeasureController(Document& document, Preview& preview, VirtualTest& test, PokeTest& poke,
                      QObject* parent);

    MeasureColumn& column() { return *m_column; }
    QWidget& charts() { return *m_charts; } ///< the one that belongs to the page

    void connectParts(const Workspaces& workspaces, const Actions& actions);

signals:
    /// Something for the line at the bottom.
    void message(const QString& text);
    /// The motion of the poke is to be written as a film.
    void filmAsked();

private:
    void takeTool();
    void makeScene();

    Document& m_document;
    Actions m_actions;
    PokeTest& m_poke;
    MeasureColumn* m_column;
    QStackedWidget* m_charts; ///< in the order of the pages
};

} // namespace esm
