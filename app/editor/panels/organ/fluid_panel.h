#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/part_finder.h"
#include "app/editor/workers/preview.h"
#include "widgets/inputs/elided_label.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QStackedWidget>

namespace esm {

/// What fills a closed part of the organ's surface: a fluid that keeps to its volume, a pressure from within,
/// and while the organ moves what they have become. One part is shown at a time, the largest at first.
class FluidPanel : public Section {
    Q_OBJECT

public:
    FluidPanel(Document& document, Preview& preview, QWidget* parent = nullptr);

private:
    void addRows();
    QWidget* pressureRow();
    void connectFields();
    void findParts();
    void listParts();
    void showChangedPart();
    void show();
    void showPressure(const PartPressure* pressure, const QString& refusal);
    void showAside();
    void showNow();
    void showNowAgain();
    void fill(bool on);
    void replacePath();
    /// The one that is shown; null without a closed part.
    const FillablePart* part() const;
    /// Why the shown part can hold nothing; empty when it can.
    QString refusal() const;
    double proposedStiffness(const FillablePart& part) const;

    Document& m_document;
    Preview& m_preview;
    PartFinder m_finder;
    PartFinder::Surface m_surface;     ///< that was looked at last
    std::vector<FillablePart> m_parts; ///< of it, those that can be filled first, the largest before others
    std::size_t m_closed = 0;          ///< of these, that can be filled
    Scene m_fluids;                    ///< as they were before the next change, and nothing else
    QComboBox* m_part;
    QCheckBox* m_filled;
    NumberField *m_stiffness, *m_pressure;
    QStackedWidget* m_besidePressure; ///< the same in kPa, or what replaces a path
    QLabel* m_inKilopascal;
    QPushButton* m_replace;
    QLabel *m_volumeNow = nullptr, *m_pressureNow = nullptr;
    ElidedLabel* m_aside; ///< on parts that are not listed
    QElapsedTimer m_shownNow;
};

} // namespace esm
