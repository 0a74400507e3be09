#include "widgets/fuzzy/partition_editor.h"

#include "widgets/fuzzy/small_font.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double handleReach = 8, snapReach = 6; // pixels

Corner neighbour(Corner corner, int direction) {
    return static_cast<Corner>(static_cast<int>(corner) + direction);
}

bool isUnsnapped(Qt::KeyboardModifiers modifiers) {
    return modifiers & (Qt::AltModifier | Qt::ControlModifier);
}

bool isOurs(const QKeyEvent& event) {
    switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        return !isUnsnapped(event.modifiers());
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
        return event.modifiers() == Qt::NoModifier;
    default:
        return false;
    }
}

} // namespace

PartitionEditor::PartitionEditor(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setSizePolicy(policy);
    setFont(smallFont(font()));
    setToolTip(tr("Drag terms and their corners. Tab goes from corner to corner, the arrow keys move one"));
}

void PartitionEditor::setVariable(const FuzzyVariable& variable) {
    m_scene.variable = variable;
    if (m_hold && !hasTerm()) m_hold.reset();
    setAccessibleName(tr("Partition of %1").arg(readableName(variable.name)));
    tellSpoken(*this);
    update();
}

void PartitionEditor::setValue(std::optional<double> value) {
    m_scene.value = value;
    update();
}

void PartitionEditor::setTerm(std::size_t term) {
    if (term == m_scene.term) return;
    letGo();
    m_scene.term = term;
    tellSpoken(*this);
    update();
}

QPoint PartitionEditor::placeOf(std::size_t term, Corner corner) const {
    return picture().placeOf(term, corner).toPoint();
}

void PartitionEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(font());
    picture().paint(painter, palette());
}

/// The nearest corner within reach. Of several in one place the first of the term in hand, else of any term.
std::optional<PartitionEditor::Handle> PartitionEditor::handleAt(const QPoint& place) const {
    const PartitionPicture drawn = picture();
    std::optional<Handle> nearest;
    double least = handleReach;
    for (std::size_t term = 0; term < m_scene.variable.terms.size(); ++term)
        for (const Corner corner : everyCorner) {
            const QPointF off = drawn.placeOf(term, corner) - place;
            // Corners of the term in hand are drawn, and easier to mean.
            const double distance = std::hypot(off.x(), off.y()) + (term == m_scene.term ? 0 : 4);
            if (distance >= least) continue;
            least = distance;
            nearest = Handle{term, corner};
        }
    return nearest;
}

std::optional<std::size_t> PartitionEditor::termAt(const QPoint& place) const {
    const PartitionPicture drawn = picture();
    if (const auto named = drawn.nameAt(place)) return named;
    const double value = drawn.valueAt(place.x()), degree = drawn.degreeAt(place.y());
    std::optional<std::size_t> found;
    double highest = 0;
    if (degree < -0.05) return found;
    for (std::size_t term = 0; term < m_scene.variable.terms.size(); ++term) {
        const double reached = membership(m_scene.variable.terms[term].set, value);
        const bool isBetter = reached > highest || (reached == highest && term == m_scene.term);
        if (reached <= 0 || reached < degree - 0.1 || !isBetter) continue;
        highest = reached;
        found = term;
    }
    return found;
}

void PartitionEditor::take(std::size_t term) {
    if (term == m_scene.term) return;
    setTerm(term);
    emit termTaken(term);
}

void PartitionEditor::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_hold) return event->ignore();
    m_keys.finish();
    if (const auto handle = handleAt(event->pos())) {
        take(handle->term);
        return hold(handle->corner, event->pos());
    }
    takeCorner(std::nullopt);
    const auto term = termAt(event->pos());
    if (!term) return;
    take(*term);
    m_hold = Hold{{}, {}, event->pos(), 0, m_scene.variable.terms[*term].set, m_scene.variable};
}

void PartitionEditor::hold(Corner corner, const QPoint& place) {
    const Trapezoid& set = m_scene.variable.terms[m_scene.term].set;
    Hold held{corner, {}, place, picture().valueAt(place.x()) - cornerOf(set, corner), set, m_scene.variable};
    const bool isTop = corner == Corner::B || corner == Corner::C;
    const Corner other =
        isTop ? (corner == Corner::B ? Corner::C : Corner::B) : (corner == Corner::A ? Corner::D : Corner::A);
    if (cornerOf(set, other) == cornerOf(set, corner)) held.other = other;
    m_hold = held;
    takeCorner(corner);
}

void PartitionEditor::mouseMoveEvent(QMouseEvent* event) {
    if (!m_hold) return setCursor(handleAt(event->pos()) ? Qt::SizeHorCursor : Qt::ArrowCursor);
    if (!hasTerm()) return m_hold.reset();
    const int moved = event->x() - m_hold->pressed.x();
    if (!m_hold->isMoving && std::abs(moved) < (m_hold->corner ? 2 : QApplication::startDragDistance()))
        return;
    if (!m_hold->isMoving && m_hold->other) {
        const auto [lower, upper] = std::minmax(*m_hold->corner, *m_hold->other);
        takeCorner(m_hold->corner = moved < 0 ? lower : upper);
    }
    m_hold->isMoving = true;
    dragTo(event->pos(), !isUnsnapped(event->modifiers()));
}

void PartitionEditor::dragTo(const QPoint& place, bool snaps) {
    const PartitionPicture drawn = picture();
    const double pixel = drawn.valuePerPixel();
    const Snapping snapping{snaps ? snapReach * pixel : 0, snaps ? roundStep(1.5 * pixel) : 0};
    if (m_hold->corner) {
        const double wanted = drawn.valueAt(place.x()) - m_hold->grabbedAt;
        const double value = snaps ? snapped(m_scene.variable, m_scene.term, wanted, snapping) : wanted;
        return shape(withCorner(m_scene.variable, m_scene.term, *m_hold->corner, value));
    }
    double by = (place.x() - m_hold->pressed.x()) * pixel;
    const double from = m_hold->before.b;
    if (snaps) by = snapped(m_hold->pressedOn, m_scene.term, from + by, snapping) - from;
    shape(shifted(m_hold->pressedOn, m_scene.term, by));
}

void PartitionEditor::shape(const Trapezoid& set) {
    m_hold->waits = m_waits;
    if (!m_waits) return emit setEdited(m_scene.term, set);
    m_scene.variable.terms[m_scene.term].set = set;
    update();
}

void PartitionEditor::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) letGo();
}

void PartitionEditor::letGo() {
    if (!m_hold) return;
    const Hold held = *m_hold;
    m_hold.reset();
    if (held.waits && hasTerm()) emit setEdited(m_scene.term, m_scene.variable.terms[m_scene.term].set);
    if (held.isMoving) emit gestureFinished();
}

void PartitionEditor::takeBack() {
    if (m_hold->isMoving) shape(m_hold->before);
    m_hold->waits = false;
    letGo();
}

void PartitionEditor::takeCorner(std::optional<Corner> corner) {
    m_scene.corner = corner;
    tellSpoken(*this);
    update();
}

bool PartitionEditor::focusNextPrevChild(bool next) {
    const Corner last = next ? Corner::D : Corner::A;
    if (!hasFocus() || !hasTerm() || m_scene.corner == last) return QWidget::focusNextPrevChild(next);
    m_keys.finish();
    takeCorner(m_scene.corner ? neighbour(*m_scene.corner, next ? 1 : -1) : next ? Corner::A : Corner::D);
    return true;
}

void PartitionEditor::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    if (!hasTerm()) return;
    if (event->reason() == Qt::TabFocusReason) takeCorner(Corner::A);
    if (event->reason() == Qt::BacktabFocusReason) takeCorner(Corner::D);
}

void PartitionEditor::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    m_keys.finish();
    takeCorner(std::nullopt);
}

void PartitionEditor::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_hold) return takeBack();
    if (!isOurs(*event) || !hasTerm() || m_hold) return QWidget::keyPressEvent(event);
    const auto terms = m_scene.variable.terms.size();
    switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
        m_keys.finish();
        return take((m_scene.term + (event->key() == Qt::Key_Down ? 1 : terms - 1)) % terms);
    case Qt::Key_Home:
        return stepTo(m_scene.variable.minimum);
    case Qt::Key_End:
        return stepTo(m_scene.variable.maximum);
    default:
        return step(event->key() == Qt::Key_Right ? 1 : -1, event->modifiers() & Qt::ShiftModifier);
    }
}

void PartitionEditor::step(int direction, bool far) {
    const FuzzyVariable& variable = m_scene.variable;
    const double width = cornerStep(variable) * (far ? 10 : 1);
    if (!m_scene.corner) takeCorner(Corner::B);
    // To the next round value, wherever it stands now.
    const double now = cornerOf(variable.terms[m_scene.term].set, *m_scene.corner) / width;
    const double next = direction > 0 ? std::floor(now + 1e-9) + 1 : std::ceil(now - 1e-9) - 1;
    stepTo(snapped(variable, m_scene.term, next * width, {0, width}));
}

void PartitionEditor::stepTo(double value) {
    if (!m_scene.corner) takeCorner(Corner::B);
    m_keys.goOn();
    emit setEdited(m_scene.term, withCorner(m_scene.variable, m_scene.term, *m_scene.corner, value));
}

QString PartitionEditor::spokenValue() const {
    if (!hasTerm()) return tr("no term in hand");
    const FuzzyTerm& term = m_scene.variable.terms[m_scene.term];
    if (!m_scene.corner) return readableName(term.name);
    const double value = cornerOf(term.set, *m_scene.corner);
    return QStringLiteral("%1 %2 %3")
        .arg(readableName(term.name), cornerUse(*m_scene.corner),
             withUnit(value, QString::fromStdString(m_scene.variable.unit)));
}

std::optional<SpokenNumber> PartitionEditor::spokenNumber() const {
    if (!hasTerm() || !m_scene.corner) return std::nullopt;
    const FuzzyVariable& variable = m_scene.variable;
    return SpokenNumber{cornerOf(variable.terms[m_scene.term].set, *m_scene.corner), variable.minimum,
                        variable.maximum, cornerStep(variable)};
}

QString PartitionEditor::explained(const QPoint& place) const {
    if (const auto handle = handleAt(place)) {
        const FuzzyTerm& term = m_scene.variable.terms[handle->term];
        return tr("%1 %2 %3. Drag it; with Alt or Ctrl it does not snap.")
            .arg(readableName(term.name), cornerUse(handle->corner),
                 numberText(cornerOf(term.set, handle->corner)));
    }
    if (const auto term = termAt(place))
        return tr("%1. A click takes it in hand, a drag moves it.")
            .arg(readableName(m_scene.variable.terms[*term].name));
    return toolTip();
}

bool PartitionEditor::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), explained(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (isOurs(*key) || (m_hold && key->key() == Qt::Key_Escape)) event->accept();
    }
    return QWidget::event(event);
}

} // namespace esm
