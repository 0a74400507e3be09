#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/workers/explanation_finder.h"
#include "widgets/fuzzy/conclusion_view.h"
#include "widgets/fuzzy/response_curve_view.h"
#include "widgets/fuzzy/response_map_view.h"
#include "widgets/fuzzy/rule_strengths.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QTimer>

namespace esm {

/// Why the selected region's fuzzy system says what it says: how strongly each rule fires, what that comes to
/// for one output, and that output over one input and over two. A click in these sets the inputs.
class WhyPanel : public QWidget {
    Q_OBJECT

public:
    WhyPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

    /// Whether all that is shown belongs to the present inputs.
    bool isUpToDate() const { return m_complete == m_asked; }

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    const Region* region() const;
    void buildChoices();
    void buildViews();
    void arrange();
    void showSystem();
    void rebuild();
    void keepApart(const QComboBox* changed);
    void chooseAxes();
    void ask();
    void showAnswer();
    std::optional<double> heldOutput() const;
    void showStale(const WhyAnswer& answer);
    void setInputs(std::optional<double> across, std::optional<double> up);

    Document& m_document;
    Selection& m_selection;
    ExplanationFinder m_finder;
    QLabel* m_failure; ///< in the content's place
    QWidget *m_choices, *m_content;
    QComboBox *m_output, *m_across, *m_up;
    RuleStrengths* m_rules;
    ConclusionView* m_conclusion;
    ResponseCurveView* m_curve;
    ResponseMapView* m_map;
    QLabel* m_noMap;
    QGridLayout* m_grid;
    std::vector<QWidget*> m_parts; ///< of the grid, each beneath its title
    std::shared_ptr<const FuzzySystem> m_system;
    /// Numbers of questions: the latest, the latest that is answered as a whole and shown, and the first
    /// about the present axes.
    int m_asked = 0, m_complete = 0, m_axesAsked = 0;
    std::shared_ptr<const ResponseCurve> m_shownCurve;
    std::shared_ptr<const ResponseMap> m_shownMap;
    QTimer m_wait; ///< runs while an answer is awaited
    int m_shownAcross = 0, m_shownUp = 0;
    bool m_isWide = false;
};

} // namespace esm
