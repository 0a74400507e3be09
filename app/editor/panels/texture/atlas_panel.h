#pragma once

#include "app/editor/document/document.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>
#include <QComboBox>

namespace esm {

/// The organ's texture space: how large it is and how well it is used.
class AtlasPanel : public Section {
    Q_OBJECT

public:
    explicit AtlasPanel(Document& document, QWidget* parent = nullptr);

private:
    void connectControls();
    void show();
    void showUse();
    void showMeasured();
    void pack(const AtlasOptions& options);
    void packAs(const AtlasOptions& options);
    void packAsOwn();
    void fill(bool on);

    Document& m_document;
    QComboBox *m_size, *m_layout;
    NumberField* m_texel;
    QCheckBox* m_fills;
    QLabel *m_pages, *m_used, *m_seams, *m_distortion, *m_flaws;
    std::shared_ptr<const Atlas> m_measured; ///< whose seams and distortion are shown
};

} // namespace esm
