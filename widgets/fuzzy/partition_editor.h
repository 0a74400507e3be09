#pragma once

#include "widgets/fuzzy/partition_picture.h"
#include "widgets/inputs/gesture.h"
#include "widgets/inputs/spoken.h"

#include <QWidget>

namespace esm {

/// The partition of a variable, its terms drawn as trapezoids over its range. The corners of the term in hand
/// are dragged: they snap to other terms' corners, the range's ends and round values, not so while Alt or
/// Ctrl is held, and never cross. Drawn at its middle a term moves as a whole. With the keys, Tab goes from
/// corner to corner, Left and Right move the corner, with Shift further, Up and Down take another term in
/// hand.
class PartitionEditor : public QWidget, public Spoken {
    Q_OBJECT

public:
    explicit PartitionEditor(QWidget* parent = nullptr);

    /// Shows a variable without announcing it.
    void setVariable(const FuzzyVariable& variable);
    /// The present value, a dashed line with the degrees it has; none hides it.
    void setValue(std::optional<double> value);
    /// Takes a term in hand without announcing it.
    void setTerm(std::size_t term);
    /// While it waits, a drag is shown here alone and told when the mouse lets go: whoever asks before an
    /// edit asks then, and shows the variable again where there is to be none.
    void setWaits(bool waits) { m_waits = waits; }
    std::size_t term() const { return m_scene.term; }
    const FuzzyVariable& variable() const { return m_scene.variable; }

    /// Where a corner of a term lies, pixels.
    QPoint placeOf(std::size_t term, Corner corner) const;

    /// How long the keys rest before what follows is another edit.
    void setPause(std::chrono::milliseconds pause) { m_keys.setPause(pause); }

    /// "medium ends at 10 mm": the term in hand, and its corner.
    QString spokenValue() const override;
    std::optional<SpokenNumber> spokenNumber() const override;
    void setSpokenNumber(double value) override { stepTo(value); }

    QSize sizeHint() const override { return {300, 168}; }
    QSize minimumSizeHint() const override { return {160, 140}; }

signals:
    void termTaken(std::size_t term);
    /// The term's set should be this one.
    void setEdited(std::size_t term, const esm::Trapezoid& set);
    /// The mouse let go or the keys rest: what follows is another edit.
    void gestureFinished();

protected:
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    /// What the mouse holds of the term in hand.
    struct Hold {
        std::optional<Corner> corner; ///< the whole term without
        std::optional<Corner> other;  ///< lies at the same place: the way the mouse goes decides
        QPoint pressed;
        double grabbedAt = 0;      ///< value under the mouse minus that of the corner
        Trapezoid before;          ///< to go back to
        FuzzyVariable pressedOn{}; ///< as it was pressed on: a whole term is shifted from there
        bool isMoving = false;
        bool waits = false; ///< what was dragged is not told yet
    };

    /// A corner that the mouse can take hold of.
    struct Handle {
        std::size_t term;
        Corner corner;
    };

    PartitionPicture picture() const { return {m_scene, rect(), font()}; }
    bool hasTerm() const { return m_scene.term < m_scene.variable.terms.size(); }
    std::optional<Handle> handleAt(const QPoint& place) const;
    std::optional<std::size_t> termAt(const QPoint& place) const;
    void take(std::size_t term);
    void hold(Corner corner, const QPoint& place);
    void dragTo(const QPoint& place, bool snaps);
    void shape(const Trapezoid& set);
    void letGo();
    void takeBack();
    void step(int direction, bool far);
    void stepTo(double value);
    void takeCorner(std::optional<Corner> corner);
    QString explained(const QPoint& place) const;

    PartitionScene m_scene;
    std::optional<Hold> m_hold;
    bool m_waits = false;
    KeyRun m_keys{[this] { emit gestureFinished(); }};
};

} // namespace esm
