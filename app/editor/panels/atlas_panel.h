#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/section.h"

#include <QComboBox>

namespace esm {

/// The organ's texture space: how large it is and how well it is used.
class AtlasPanel : public Section {
    Q_OBJECT

public:
    explicit AtlasPanel(Document& document, QWidget* parent = nullptr);

private:
    void show();
    void pack();

    Document& m_document;
    QComboBox *m_size, *m_layout;
    QLabel *m_used, *m_texel, *m_seams;
};

} // namespace esm
