#pragma once

#include "app/editor/panels/measure/speed_and_accuracy.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"

#include <QPushButton>

namespace esm {

/// What of speed and accuracy is asked and answered in words: by what method and step the tissue moves, what
/// the user wishes, and what was measured to be best.
class AccuracyPanel : public Section {
    Q_OBJECT

public:
    AccuracyPanel(Document& document, SpeedAndAccuracy& accuracy, QWidget* parent = nullptr);

private:
    QWidget* buildMeasured();
    void refresh();
    QString hint() const;
    void showInUse();
    void showRecommendation(QPushButton* button, std::optional<std::size_t> run, const QString& none);

    Document& m_document;
    SpeedAndAccuracy& m_accuracy;
    QPushButton* m_measure;
    QLabel* m_inUse;
    QToolButton* m_automatic;
    QLabel* m_hint;
    QLabel* m_scene;
    NumberField* m_mostError;
    QPushButton *m_inRealTime, *m_toError;
    QWidget* m_measured; ///< what is shown of a measurement
};

} // namespace esm
