#pragma once

#include "app/editor/document/document.h"

#include <QCheckBox>

namespace esm {

/// Whether a hollow organ's wall resists bending. What is filled, rigid or without a surface has no wall, and
/// no such box.
class BendingBox : public QWidget {
    Q_OBJECT

public:
    explicit BendingBox(Document& document, QWidget* parent = nullptr);

private:
    void show();

    Document& m_document;
    QCheckBox* m_resists;
};

} // namespace esm
