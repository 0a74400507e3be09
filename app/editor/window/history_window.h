#pragma once

#include "app/editor/document/document.h"

#include <QDialog>
#include <QListWidget>

namespace esm {

/// The undo list, to jump in: what is undone is shown quietly below what is done.
class HistoryWindow : public QDialog {
    Q_OBJECT

public:
    explicit HistoryWindow(Document& document, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fill();
    void markDone();

    Document& m_document;
    QListWidget* m_list;
};

} // namespace esm
