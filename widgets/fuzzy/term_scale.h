#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace esm {

/// A name as people read it: "very_small" is "very small".
QString readableName(const std::string& name);

/// The terms of a variable in their order, spread over the width; those the value belongs to stand out. A
/// click on a term asks for the middle of its core.
class TermScale : public QWidget {
    Q_OBJECT

public:
    explicit TermScale(QWidget* parent = nullptr);

    void setVariable(const FuzzyVariable& variable);
    void setValue(std::optional<double> value);
    /// Shown in place of the terms, when there is no value; empty shows the terms.
    void setNote(const QString& note);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void termPicked(double value);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Small enough for all terms, down to three quarters.
    QFont fittingFont() const;
    std::vector<QRect> termRects() const;
    int termAt(const QPoint& position) const;

    FuzzyVariable m_variable;
    std::optional<double> m_value;
    QString m_note;
};

} // namespace esm
