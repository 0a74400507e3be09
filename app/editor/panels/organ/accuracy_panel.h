#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/preview.h"
#include "core/dynamics/measure/tradeoff.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/section.h"
#include "widgets/plot/accuracy_chart.h"

#include <QPushButton>
#include <QTimer>

namespace esm {

/// How fast and how exactly this machine can compute the organ's motion, by every method: measured on
/// request, and one of them chosen.
class AccuracyPanel : public Section {
    Q_OBJECT

public:
    AccuracyPanel(Document& document, Preview& preview, QWidget* parent = nullptr);

    /// Whether the tissue is yet to be compared with the one that the step was chosen for, once edits rest.
    bool isComparing() const { return m_rest.isActive(); }

private:
    /// Holds for the organ it was made on, on all of its nodes and on fewer.
    struct Measurement {
        Project project; ///< that was measured
        Tradeoff tradeoff;
        std::vector<Project> onFewerNodes{}; ///< the same, as one of its runs was chosen
    };

    /// Of a project beside that of the measurement.
    enum class Tissue { Measured, Other };

    QWidget* buildMeasured();
    void measure();
    void refresh();
    void compareTissue();
    void showInUse();
    void showMeasurement();
    void showRecommendations();
    void showRecommendation(QPushButton* button, std::optional<std::size_t> run, const QString& none);
    bool isMeasured() const;
    bool isOutdated() const;
    Project onMeasuredNodes(Project project, Tissue tissue) const;
    void use(std::size_t run);
    void useAutomatic();

    Document& m_document;
    Preview& m_preview;
    std::optional<Measurement> m_measurement;
    QTimer m_rest;                    ///< until the tissue is compared
    bool m_isFromOtherTissue = false; ///< what is in use
    QToolButton* m_measure;
    QLabel* m_inUse;
    QToolButton* m_automatic;
    QLabel* m_hint;
    AccuracyChart* m_chart;
    NumberField* m_mostError;
    QPushButton *m_inRealTime, *m_toError;
    QWidget* m_measured; ///< what is shown of a measurement
};

} // namespace esm
