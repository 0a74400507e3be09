#include "widgets/fuzzy/response_map_view.h"

#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <algorithm>
#include <array>

namespace esm {

namespace {

constexpr double mapLegendWidth = 10, mapLegendGap = 10, mapRowsPerMark = 34; // pixels

} // namespace

/// The colours of viridis (van der Walt and Smith 2015): lightness rises evenly, so that they can be read by
/// the colour-blind and in grey.
QColor mapColour(double share) {
    constexpr std::array<QRgb, 9> stops{0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                        0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
    const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    const double part = place - static_cast<double>(below);
    const auto mixed = [&](int (*channel)(QRgb)) {
        return qRound((1 - part) * channel(stops[below]) + part * channel(stops[below + 1]));
    };
    return {mixed(qRed), mixed(qGreen), mixed(qBlue)};
}

ResponseMapView::ResponseMapView(QWidget* parent) : ResponseView(parent) {
    setObjectName(QStringLiteral("responseMap"));
    setToolTip(tr("A click or a drag sets both inputs, and so do the arrow keys"));
}

void ResponseMapView::setAxes(const Axes& axes) {
    m_acrossName = readableName(axes.across.name);
    m_upName = readableName(axes.up.name);
    m_outputName = readableName(axes.output.name);
    m_across = {axes.across.minimum, axes.across.maximum, QString::fromStdString(axes.across.unit)};
    m_up = {axes.up.minimum, axes.up.maximum, QString::fromStdString(axes.up.unit)};
    m_values = axes.values;
    m_map = {};
    m_picture = {};
    setAccessibleName(tr("%1 over %2 and %3").arg(m_outputName, m_acrossName, m_upName));
    update();
}

void ResponseMapView::setMap(ResponseMap map) {
    m_map = std::move(map);
    for (const auto& value : m_map.values) {
        m_values.minimum = std::min(m_values.minimum, value.value_or(m_values.minimum));
        m_values.maximum = std::max(m_values.maximum, value.value_or(m_values.maximum));
    }
    const int cells = static_cast<int>(m_map.cells);
    m_picture = QImage(cells, cells, QImage::Format_ARGB32);
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const auto& value = m_map.at(static_cast<std::size_t>(column), static_cast<std::size_t>(row));
            const QColor colour =
                value ? mapColour((*value - m_values.minimum) / m_values.width()) : QColor(Qt::transparent);
            m_picture.setPixelColor(column, cells - 1 - row, colour);
        }
    update();
}

PlotFrame ResponseMapView::frame() const {
    const QFontMetricsF metrics(font());
    const double line = metrics.height(), numbers = metrics.horizontalAdvance(QStringLiteral("000")) + 8;
    const double legend = mapLegendGap + mapLegendWidth + 6 +
                          metrics.horizontalAdvance(QStringLiteral("000.0 ") + m_values.unit);
    return {QRectF(rect()).adjusted(numbers, 2 * line + 8, -legend, -2 * line - 6), m_across, m_up};
}

std::optional<double> ResponseMapView::outputAt(double across, double up) const {
    if (m_map.cells == 0) return std::nullopt;
    const auto cell = [&](double value, const PlotRange& range) {
        const double share = std::clamp((value - range.minimum) / range.width(), 0.0, 1.0);
        return std::min(static_cast<std::size_t>(share * static_cast<double>(m_map.cells)), m_map.cells - 1);
    };
    return m_map.at(cell(across, m_across), cell(up, m_up));
}

QString ResponseMapView::textAt(const std::optional<QPointF>& place) const {
    const PlotFrame shown = frame();
    const auto across = place ? std::optional(shown.acrossAt(place->x())) : m_presentAcross;
    const auto up = place ? std::optional(shown.upAt(place->y())) : m_presentUp;
    const auto input = [](const QString& name, std::optional<double> value, const QString& unit) {
        return name + ' ' + (value ? withUnit(*value, unit) : tr("left out"));
    };
    // Elsewhere it is known in the middles of the cells alone.
    const auto output = place ? outputAt(*across, *up) : m_presentOutput;
    const QString about = place ? QStringLiteral("≈ ") : QString();
    return tr("%1, %2: %3")
        .arg(input(m_acrossName, across, m_across.unit), input(m_upName, up, m_up.unit),
             output ? about + withUnit(*output, m_values.unit) : tr("not reached by any rule"));
}

void ResponseMapView::draw(QPainter& painter, const PlotFrame& frame) {
    const QRectF& area = frame.area();
    painter.fillRect(area, palette().color(QPalette::Base));
    painter.fillRect(area, QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    if (!m_picture.isNull()) painter.drawImage(area, m_picture);
    frame.drawAcross(painter, palette());
    const QFontMetricsF metrics(painter.font());
    frame.drawUpNumbers(painter, palette(), mapRowsPerMark);
    painter.drawText(QPointF(area.left(), area.top() - 5), QChar(0x2191) + (' ' + m_upName));
    const QString acrossText = m_acrossName + ' ' + QChar(0x2192);
    painter.drawText(QPointF(area.right() - metrics.horizontalAdvance(acrossText),
                             area.bottom() + 5 + metrics.ascent() + metrics.height()),
                     acrossText);
    drawLegend(painter, frame);
    drawPresent(painter, frame);
}

void ResponseMapView::drawLegend(QPainter& painter, const PlotFrame& frame) const {
    const QRectF& area = frame.area();
    const QRectF bar(area.right() + mapLegendGap, area.top(), mapLegendWidth, area.height());
    QLinearGradient colours(bar.bottomLeft(), bar.topLeft());
    for (int i = 0; i <= 8; ++i)
        colours.setColorAt(i / 8.0, mapColour(i / 8.0));
    painter.fillRect(bar, colours);
    const QFontMetricsF metrics(painter.font());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const auto label = [&](double value, double baseline) {
        painter.drawText(QPointF(bar.right() + 5, baseline), withUnit(value, m_values.unit, 3));
    };
    label(m_values.maximum, bar.top() + metrics.ascent());
    label(m_values.minimum, bar.bottom());
    label((m_values.minimum + m_values.maximum) / 2, bar.center().y() + metrics.capHeight() / 2);
}

void ResponseMapView::drawPresent(QPainter& painter, const PlotFrame& frame) const {
    if (!m_presentAcross || !m_presentUp) return;
    const QPointF place = frame.at(std::clamp(*m_presentAcross, m_across.minimum, m_across.maximum),
                                   std::clamp(*m_presentUp, m_up.minimum, m_up.maximum));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 4));
    painter.drawEllipse(place, 6, 6);
    painter.setPen(QPen(Qt::white, 2));
    painter.drawEllipse(place, 6, 6);
}

} // namespace esm
