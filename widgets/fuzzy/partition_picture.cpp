#include "widgets/fuzzy/partition_picture.h"

#include "widgets/fuzzy/term_layout.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double side = 9, nameGap = 7, beneathNames = 8, aboveNumbers = 4; // pixels
constexpr double handleRadius = 4.5;

double nameWidth(const FuzzyTerm& term, const QFontMetricsF& metrics) {
    return metrics.horizontalAdvance(readableName(term.name)) + 2;
}

double middleOf(const Trapezoid& set) {
    return set.b + (set.c - set.b) / 2;
}

} // namespace

QColor termColour(std::size_t term, std::size_t terms, const QPalette& palette) {
    const double share = terms > 1 ? static_cast<double>(term) / static_cast<double>(terms - 1) : 0;
    const bool onDark = palette.color(QPalette::Window).lightnessF() < 0.5;
    // Neighbours differ in lightness too, for whoever cannot tell the hues.
    const double lighter = term % 2 == 0 ? 0 : 0.07;
    return QColor::fromHslF(0.57 + 0.36 * share, onDark ? 0.55 : 0.5, (onDark ? 0.7 : 0.34) + lighter);
}

QString cornerUse(Corner corner) {
    switch (corner) {
    case Corner::A:
        return QObject::tr("begins at");
    case Corner::B:
        return QObject::tr("full from");
    case Corner::C:
        return QObject::tr("full to");
    default:
        return QObject::tr("ends at");
    }
}

double cornerStep(const FuzzyVariable& variable) {
    return roundStep((variable.maximum - variable.minimum) / 150);
}

PartitionPicture::PartitionPicture(const PartitionScene& scene, const QRect& place, const QFont& font)
    : m_scene(scene), m_metrics(font), m_place(place) {
    const int rows = nameRows(scene.variable, place.width(), font);
    m_plot = m_place.adjusted(side, rows * m_metrics.height() + beneathNames, -side,
                              -m_metrics.height() - aboveNumbers);
}

int PartitionPicture::nameRows(const FuzzyVariable& variable, int width, const QFont& font) {
    const QFontMetricsF metrics(font);
    double needed = -nameGap;
    for (const FuzzyTerm& term : variable.terms)
        needed += nameWidth(term, metrics) + nameGap;
    return needed > 0.8 * width ? 2 : 1;
}

QPointF PartitionPicture::placeOf(double value, double degree) const {
    const FuzzyVariable& variable = m_scene.variable;
    const double share = (value - variable.minimum) / (variable.maximum - variable.minimum);
    return {m_plot.left() + share * m_plot.width(), m_plot.bottom() - degree * m_plot.height()};
}

QPointF PartitionPicture::placeOf(std::size_t term, Corner corner) const {
    const bool isTop = corner == Corner::B || corner == Corner::C;
    return placeOf(cornerOf(m_scene.variable.terms[term].set, corner), isTop ? 1 : 0);
}

double PartitionPicture::valuePerPixel() const {
    return (m_scene.variable.maximum - m_scene.variable.minimum) / std::max(1.0, m_plot.width());
}

double PartitionPicture::valueAt(double x) const {
    return m_scene.variable.minimum + (x - m_plot.left()) * valuePerPixel();
}

double PartitionPicture::degreeAt(double y) const {
    return (m_plot.bottom() - y) / std::max(1.0, m_plot.height());
}

void PartitionPicture::paint(QPainter& painter, const QPalette& palette) const {
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxis(painter, palette);
    for (std::size_t term = 0; term < m_scene.variable.terms.size(); ++term)
        if (term != m_scene.term) paintTerm(painter, palette, term);
    if (m_scene.term < m_scene.variable.terms.size()) paintTerm(painter, palette, m_scene.term);
    paintValue(painter, palette);
    paintNames(painter, palette);
    if (m_scene.term < m_scene.variable.terms.size()) paintCorners(painter, palette);
}

void PartitionPicture::paintAxis(QPainter& painter, const QPalette& palette) const {
    painter.setPen(QPen(palette.color(QPalette::Mid), 1));
    painter.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
    painter.drawLine(m_plot.bottomLeft(), m_plot.topLeft());
    painter.setPen(palette.color(QPalette::PlaceholderText));
    const QRectF numbers(m_place.left(), m_plot.bottom() + aboveNumbers, m_place.width(), m_metrics.height());
    const QString unit = QString::fromStdString(m_scene.variable.unit);
    painter.drawText(numbers.adjusted(side - 2, 0, 0, 0), Qt::AlignLeft,
                     withUnit(m_scene.variable.minimum, unit));
    painter.drawText(numbers.adjusted(0, 0, -side + 2, 0), Qt::AlignRight,
                     withUnit(m_scene.variable.maximum, unit));
}

void PartitionPicture::paintTerm(QPainter& painter, const QPalette& palette, std::size_t term) const {
    const bool isInHand = term == m_scene.term;
    QPolygonF outline;
    for (const Corner corner : everyCorner)
        outline << placeOf(term, corner);
    QColor line = termColour(term, m_scene.variable.terms.size(), palette);
    if (isInHand) line = palette.color(QPalette::Link);
    QColor fill = line;
    fill.setAlphaF(isInHand ? 0.24 : 0.07);
    painter.save();
    painter.setClipRect(m_plot.adjusted(-2, -3, 2, 2));
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(outline);
    painter.setPen(QPen(line, isInHand ? 2 : 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(outline);
    painter.restore();
}

std::vector<PartitionPicture::Name> PartitionPicture::placedNames() const {
    const auto& terms = m_scene.variable.terms;
    std::vector<std::size_t> rising(terms.size());
    for (std::size_t i = 0; i < rising.size(); ++i)
        rising[i] = i;
    std::stable_sort(rising.begin(), rising.end(), [&](std::size_t one, std::size_t other) {
        return middleOf(terms[one].set) < middleOf(terms[other].set);
    });
    const auto rows = static_cast<std::size_t>(
        std::lround((m_plot.top() - beneathNames - m_place.top()) / m_metrics.height()));
    std::vector<Name> names;
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<PlacedWord> words;
        std::vector<std::size_t> members;
        double total = 0;
        for (std::size_t i = row; i < rising.size(); i += rows) {
            members.push_back(rising[i]);
            total += nameWidth(terms[rising[i]], m_metrics);
        }
        const double room = m_place.width() - nameGap * (static_cast<double>(members.size()) - 1);
        const double shrink = total > room ? std::max(0.0, room) / total : 1;
        for (const std::size_t term : members) {
            const double x = placeOf(middleOf(terms[term].set), 1).x() - m_place.left();
            words.push_back(
                {std::clamp(x, 0.0, m_place.width()), shrink * nameWidth(terms[term], m_metrics)});
        }
        const std::vector<double> lefts = spreadWords(words, m_place.width(), nameGap);
        for (std::size_t i = 0; i < members.size(); ++i)
            names.push_back(
                {members[i],
                 {m_place.left() + lefts[i], m_place.top() + static_cast<double>(row) * m_metrics.height(),
                  words[i].width, m_metrics.height()}});
    }
    return names;
}

void PartitionPicture::paintNames(QPainter& painter, const QPalette& palette) const {
    const auto& terms = m_scene.variable.terms;
    for (const Name& name : placedNames()) {
        const bool isInHand = name.term == m_scene.term;
        painter.setPen(isInHand ? palette.color(QPalette::Link)
                                : termColour(name.term, terms.size(), palette));
        const QString text = m_metrics.elidedText(readableName(terms[name.term].name), Qt::ElideRight,
                                                  name.rect.width() + 0.5);
        painter.drawText(name.rect, Qt::AlignCenter, text);
    }
}

std::optional<std::size_t> PartitionPicture::nameAt(const QPointF& place) const {
    for (const Name& name : placedNames())
        if (name.rect.adjusted(-2, 0, 2, 0).contains(place)) return name.term;
    return std::nullopt;
}

void PartitionPicture::paintValue(QPainter& painter, const QPalette& palette) const {
    const FuzzyVariable& variable = m_scene.variable;
    if (!m_scene.value || *m_scene.value < variable.minimum || *m_scene.value > variable.maximum) return;
    const double x = placeOf(*m_scene.value, 0).x();
    painter.setPen(QPen(palette.color(QPalette::WindowText), 1, Qt::DashLine));
    painter.drawLine(QPointF(x, m_plot.top() - 4), QPointF(x, m_plot.bottom()));
    // By turns at either side, so that equal degrees do not lie over each other.
    bool atRight = true;
    for (const FuzzyTerm& term : variable.terms) {
        const double degree = membership(term.set, *m_scene.value);
        if (degree <= 0) continue;
        paintDegree(painter, palette, degree, atRight);
        atRight = !atRight;
    }
}

void PartitionPicture::paintDegree(QPainter& painter, const QPalette& palette, double degree,
                                   bool atRight) const {
    const QColor& colour = palette.color(QPalette::WindowText);
    const QPointF at = placeOf(*m_scene.value, degree);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(at, 2.5, 2.5);
    const QString text = QString::number(degree, 'f', 2);
    const double width = m_metrics.horizontalAdvance(text), height = m_metrics.height();
    if (atRight ? at.x() + 7 + width > m_place.right() : at.x() - 7 - width < m_place.left())
        atRight = !atRight;
    const double middle = std::clamp(at.y(), m_plot.top() + height / 2, m_plot.bottom() - height / 2);
    const QRectF place(atRight ? at.x() + 7 : at.x() - 7 - width, middle - height / 2, width, height);
    QColor behind = palette.color(QPalette::Window);
    behind.setAlphaF(0.75);
    painter.setBrush(behind);
    painter.drawRoundedRect(place.adjusted(-2, 1, 2, -1), 2, 2);
    painter.setPen(colour);
    painter.drawText(place, Qt::AlignCenter, text);
}

void PartitionPicture::paintCorners(QPainter& painter, const QPalette& palette) const {
    const QColor& accent = palette.color(QPalette::Link);
    for (const Corner corner : everyCorner) {
        const bool isHeld = m_scene.corner == corner;
        painter.setPen(QPen(accent, 2));
        painter.setBrush(isHeld ? accent : palette.color(QPalette::Base));
        const QPointF at = placeOf(m_scene.term, corner);
        if (at.x() < m_plot.left() - 1 || at.x() > m_plot.right() + 1) continue;
        painter.drawEllipse(at, handleRadius, handleRadius);
        if (!isHeld) continue;
        painter.setPen(QPen(palette.color(QPalette::WindowText), 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, handleRadius + 3, handleRadius + 3);
    }
}

} // namespace esm
