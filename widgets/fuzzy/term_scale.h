#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "widgets/inputs/spoken.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace esm {

/// A name as people read it: "very_small" is "very small".
QString readableName(const std::string& name);

/// "flexible 0.92, medium 0.08": the terms that a value belongs to, as people read them.
QString wordsFor(const FuzzyVariable& variable, double value);

/// The terms of a variable, each beneath the middle of its core on the slider above, in two rows where one is
/// too narrow; a tick marks the place exactly. Terms the value belongs to stand out. A click on a term asks
/// for the middle of its core.
class TermScale : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit TermScale(QWidget* parent = nullptr);

    void setVariable(const FuzzyVariable& variable);
    void setValue(std::optional<double> value);
    /// How far from either end the variable's range begins, pixels: where the slider's handle stands at its
    /// ends.
    void setInset(int pixels);
    /// Shown in place of the terms, when there is no value; empty shows the terms.
    void setNote(const QString& note);
    const QString& note() const { return m_note; }

    QString spokenValue() const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void termPicked(double value);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Where a word stands.
    struct Place {
        std::size_t term;
        double tick; ///< x of the middle of its core
        QRect rect;
    };

    void layOut();
    std::vector<Place> inRows(int rows) const;
    void placeRow(std::vector<Place*>& row, int top) const;
    double wordWidth(std::size_t term) const;
    int termAt(const QPoint& position) const;
    QString explained(const FuzzyTerm& term) const;
    QColor colourOf(const FuzzyTerm& term) const;

    FuzzyVariable m_variable;
    std::optional<double> m_value;
    QString m_note;
    int m_inset = 0, m_rows = 1;
    std::vector<Place> m_places;
};

} // namespace esm
