#pragma once

#include "core/fuzzy/explanation.h"
#include "widgets/inputs/spoken.h"

#include <QAbstractScrollArea>

#include <memory>
#include <optional>
#include <vector>

namespace esm {

/// The rules of a system in words, each with how strongly it fires: a bar behind the words and the degree.
/// A click or the arrow keys choose one, Escape or a second click none.
class RuleStrengths : public QAbstractScrollArea, public Spoken {
    Q_OBJECT

public:
    explicit RuleStrengths(QWidget* parent = nullptr);

    /// Degrees are told anew by setExplanations().
    void setSystem(std::shared_ptr<const FuzzySystem> system);
    /// One per rule.
    void setExplanations(std::vector<RuleExplanation> rules);
    /// Otherwise in the system's order.
    void setStrongestFirst(bool on);

    std::optional<std::size_t> chosenRule() const { return m_chosen; }
    /// The rules from top to bottom.
    const std::vector<std::size_t>& order() const { return m_order; }
    /// How the degree comes about, word by word.
    QString explained(std::size_t rule) const;

    /// The chosen rule, else how many there are.
    QString spokenValue() const override;
    QSize sizeHint() const override { return {300, 190}; }
    QSize minimumSizeHint() const override { return {180, 120}; }

signals:
    void ruleChosen();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    void measure();
    void arrange();
    void choose(std::optional<std::size_t> rule);
    void bringIntoView(std::size_t place);
    std::optional<std::size_t> ruleAt(int y) const;
    std::optional<std::size_t> placeOfChosen() const;
    void drawRule(QPainter& painter, std::size_t rule, const QRect& row) const;
    QRect wordsIn(const QRect& row) const;

    std::shared_ptr<const FuzzySystem> m_system;
    std::vector<QString> m_words; ///< per rule
    std::vector<RuleExplanation> m_rules;
    std::vector<int> m_heights;       ///< per rule, pixels
    std::vector<std::size_t> m_order; ///< from top to bottom
    std::vector<int> m_tops;          ///< of the rows, and the end of the last one
    std::optional<std::size_t> m_chosen;
    bool m_strongestFirst = true;
};

} // namespace esm
