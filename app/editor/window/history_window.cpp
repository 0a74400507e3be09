#include "app/editor/window/history_window.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

namespace esm {

HistoryWindow::HistoryWindow(Document& document, QWidget* parent)
    : QDialog(parent), m_document(document), m_list(new QListWidget(this)) {
    setObjectName(QStringLiteral("historyWindow"));
    setWindowTitle(tr("Undo history"));
    resize(280, 420);
    m_list->setObjectName(QStringLiteral("historyList"));
    m_list->setAccessibleName(windowTitle());
    m_list->setToolTip(tr("Choose a step to go back or forward to how the organ was after it"));
    m_list->setWordWrap(true);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_list);
    connect(m_list, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0) m_document.goTo(row);
    });
    connect(&document, &Document::stepped, this, &HistoryWindow::fill);
    connect(&document, &Document::replaced, this, &HistoryWindow::fill);
    connect(&document, &Document::titleChanged, this, &HistoryWindow::markDone);
}

void HistoryWindow::showEvent(QShowEvent* event) {
    fill();
    QDialog::showEvent(event);
}

/// Only where it is seen: a drag makes a step of every move of the mouse.
void HistoryWindow::fill() {
    if (isHidden()) return;
    const QSignalBlocker quiet(m_list);
    const QUndoStack& steps = *m_document.undoStack();
    while (m_list->count() > steps.count() + 1)
        delete m_list->takeItem(m_list->count() - 1);
    while (m_list->count() < steps.count() + 1)
        new QListWidgetItem(m_list);
    for (int i = 0; i < steps.count(); ++i)
        m_list->item(i + 1)->setText(m_document.stepText(i));
    markDone();
}

void HistoryWindow::markDone() {
    if (isHidden()) return;
    const QSignalBlocker quiet(m_list);
    const QUndoStack& steps = *m_document.undoStack();
    const bool isLimited = steps.count() == Document::mostSteps; // what was before is given up
    m_list->item(0)->setText(isLimited ? tr("Before the last %1 steps").arg(Document::mostSteps)
                                       : tr("As it began"));
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem* item = m_list->item(row);
        item->setForeground(palette().color(row > steps.index() ? QPalette::Disabled : QPalette::Normal,
                                            QPalette::WindowText));
        QFont font = m_list->font();
        font.setBold(row == steps.index());
        item->setFont(font);
        const bool isSaved = row == steps.cleanIndex();
        item->setToolTip(isSaved && m_document.path() ? tr("As it lies in the file") : QString());
    }
    m_list->setCurrentRow(steps.index());
}

} // namespace esm
