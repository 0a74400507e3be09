#include "app/editor/dialogs/opening_options.h"

#include "core/geometry/hole_filling.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quiet_label.h"

#include <QGridLayout>

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double usualSlit = 6e-4;    // m
constexpr std::size_t usualHole = 30; ///< edges
constexpr int numberWidth = 100;      ///< pixels
/// A border so many times as long as it is wide is taken for a slit.
constexpr double slitShape = 8;

QString edgesText(std::size_t count) {
    return count == 1 ? QObject::tr("1 edge") : QObject::tr("%1 edges").arg(countText(count));
}

QString inMillimetres(double metres) {
    return QObject::tr("%1 mm").arg(numberText(metres * 1000, 2));
}

/// Rounded down to what the field shows of it, so that no width that is shown is above the limit.
double widest(const ImportedSurface& surface, LengthUnit unit) {
    constexpr double rounding = 1 + 1e-12;
    const double most = widestSlit(surface.extent.maxCoeff()) * metresPer(unit);
    const double step = most > 1e-3 ? 1e-5 : std::pow(10, std::floor(std::log10(most)) - 2);
    return std::floor(most / step * rounding) * step;
}

/// Border edges of no loop.
std::size_t looseEdges(const ImportedSurface& surface) {
    return surface.report.boundaryEdges - edgesOf(surface.borders);
}

QString filledText(const RepairReport& report) {
    QString filled = report.filledHoles == 1
                         ? QObject::tr("1 hole filled, %1").arg(edgesText(report.filledHoleEdges))
                         : QObject::tr("%1 holes filled, %2")
                               .arg(countText(report.filledHoles), edgesText(report.filledHoleEdges));
    if (report.refusedHoles == 0) return filled;
    return QObject::tr("%1; %2 cannot be").arg(filled, countText(report.refusedHoles));
}

/// What stays open once slits are closed and holes filled.
QString leftText(const ImportedSurface& surface) {
    const std::size_t edges = surface.report.boundaryEdges, loose = looseEdges(surface);
    if (edges == 0) return QObject::tr("Left open: nothing");
    QString left = QObject::tr("Left open: %1").arg(edgesText(edges));
    if (loose == 0) return left;
    return loose == edges ? QObject::tr("%1, around no hole").arg(left)
                          : QObject::tr("%1, %2 of them around no hole").arg(left, countText(loose));
}

/// What is shown as 0.01 mm, on an organ of any usual size.
double leastWidth(double most) {
    return std::min(1e-5, most / 100);
}

NumberFormat widthFormat(double most) {
    NumberFormat format;
    format.unit = QStringLiteral("mm");
    format.shownPerValue = 1000;
    if (most > 1e-3) format.decimals = 2;
    format.minimum = leastWidth(most);
    format.maximum = most;
    return format;
}

NumberFormat edgesFormat() {
    NumberFormat format;
    format.decimals = 0;
    format.minimum = 3;
    format.maximum = mostHoleEdges;
    return format;
}

/// Keeps the room of a line for what is said later.
void keepLine(QLabel* label) {
    label->ensurePolished();
    label->setText(QStringLiteral("0"));
    label->setMinimumHeight(label->sizeHint().height());
}

bool isSlit(const OpenBorder& border) {
    return std::isfinite(border.gap) && border.length > slitShape * border.gap;
}

} // namespace

OpeningOptions::OpeningOptions(std::shared_ptr<const ImportedSurface> found, LengthUnit unit, QWidget* parent)
    : QWidget(parent), m_found(std::move(found)), m_open(new QLabel(this)),
      m_closes(new QCheckBox(tr("C&lose slits up to"), this)),
      m_fills(new QCheckBox(tr("&Fill holes of up to"), this)),
      m_width(new NumberField(widthFormat(widest(*m_found, unit)), this)),
      m_edges(new NumberField(edgesFormat(), this)), m_widthLimits(quietLabel({}, this)),
      m_closed(new QLabel(this)), m_filled(new QLabel(this)), m_left(new QLabel(this)) {
    m_open->setObjectName(QStringLiteral("openBorders"));
    m_open->setWordWrap(true);
    m_closes->setObjectName(QStringLiteral("closesSlits"));
    m_fills->setObjectName(QStringLiteral("fillsHoles"));
    m_width->setObjectName(QStringLiteral("slitWidth"));
    m_edges->setObjectName(QStringLiteral("holeEdges"));
    m_closed->setObjectName(QStringLiteral("closedSlits"));
    m_filled->setObjectName(QStringLiteral("filledHoles"));
    m_left->setObjectName(QStringLiteral("leftOpen"));
    m_left->setToolTip(tr("The free edge of a wall or flap inside begins and ends where parts of the surface "
                          "meet: it goes around no hole, and cannot be filled"));
    m_width->setAccessibleName(tr("Width of slits to close"));
    m_edges->setAccessibleName(tr("Edges of holes to fill"));
    auto* edgesLimits = quietLabel({}, this);
    edgesLimits->setText(tr("edges, 3 to %1").arg(mostHoleEdges));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    grid->setColumnStretch(3, 1);
    grid->addWidget(m_open, 0, 0, 1, 4);
    // What a choice did stands below it; the room for it is kept, so that nothing moves.
    const auto addRow = [grid](int row, QWidget* chosen, QWidget* number, QWidget* limits, QLabel* done) {
        grid->addWidget(chosen, row, 0);
        grid->addWidget(number, row, 1);
        grid->addWidget(limits, row, 2);
        grid->addWidget(done, row + 1, 1, 1, 3);
        number->setFixedWidth(numberWidth);
        keepLine(done);
    };
    addRow(1, m_closes, m_width, m_widthLimits, m_closed);
    addRow(3, m_fills, m_edges, edgesLimits, m_filled);
    grid->addWidget(m_left, 5, 0, 1, 4);
    keepLine(m_left);
    m_edges->setValue(static_cast<double>(usualHole));
    connectRow(m_closes, m_width);
    connectRow(m_fills, m_edges);
    connect(m_width, &NumberField::valueEdited, this, [this] { m_isWidthTyped = true; });
    setUnit(unit);
    showDone(nullptr);
}

void OpeningOptions::connectRow(QCheckBox* chosen, NumberField* number) {
    const bool isOpen = m_found->report.boundaryEdges > 0;
    const bool isWidth = number == m_width;
    enable(chosen, isOpen,
           isWidth ? tr("Borders no farther apart than this are stitched together")
                   : tr("Open borders of at most so many edges are filled with triangles"),
           tr("The surface has no open border"));
    const auto show = [chosen, number, isWidth] {
        enable(number, chosen->isChecked(),
               isWidth ? tr("Of the organ's own size; at most a tenth of it")
                       : tr("Once slits are closed; the ends of a tube are holes too"),
               tr("Tick the box before it first"));
    };
    show();
    connect(chosen, &QCheckBox::toggled, this, [this, show] {
        show();
        emit changed();
    });
    connect(number, &NumberField::valueEdited, this, &OpeningOptions::changed);
}

void OpeningOptions::setUnit(LengthUnit unit) {
    const double most = widest(*m_found, unit);
    m_width->setFormat(widthFormat(most));
    if (m_width->refusal().isEmpty())
        m_width->setValue(
            std::clamp(m_isWidthTyped ? m_width->value().value_or(usualSlit) : proposedWidth(unit),
                       leastWidth(most), most));
    m_widthLimits->setText(tr("at most %1 mm")
                               .arg(m_width->format().decimals < 0
                                        ? numberText(most * 1000)
                                        : decimalText(most * 1000, m_width->format().decimals)));
    m_open->setText(foundText(unit));
}

/// A little more than the widest slit there is.
double OpeningOptions::proposedWidth(LengthUnit unit) const {
    double width = 0;
    for (const OpenBorder& border : m_found->borders)
        if (isSlit(border)) width = std::max(width, 1.1 * border.gap * metresPer(unit));
    return width > 0 ? width : usualSlit;
}

QString OpeningOptions::foundText(LengthUnit unit) const {
    const auto& borders = m_found->borders;
    const std::size_t edges = m_found->report.boundaryEdges, loose = looseEdges(*m_found);
    if (edges == 0) return tr("No open border");
    if (borders.empty()) return tr("In the file: %1 of open borders around no hole").arg(edgesText(edges));
    const OpenBorder& largest = borders.front();
    const QString size = edgesText(largest.loop.size());
    QString text = borders.size() == 1 ? tr("In the file: 1 open border: %1").arg(size)
                                       : tr("In the file: %1 open borders, %2; the largest: %3")
                                             .arg(borders.size())
                                             .arg(edgesText(edges - loose), size);
    if (std::isfinite(largest.gap))
        text = tr("%1, its sides %2 apart").arg(text, inMillimetres(largest.gap * metresPer(unit)));
    return loose == 0 ? text : tr("%1. And %2 around no hole").arg(text, edgesText(loose));
}

void OpeningOptions::showDone(const ImportedSurface* surface) {
    const bool closes = m_closes->isChecked(), fills = m_fills->isChecked();
    const auto show = [surface](QLabel* label, bool isAsked, const auto& textOf) {
        label->setText(!isAsked ? QString() : surface ? textOf(*surface) : QStringLiteral("…"));
    };
    show(m_closed, closes, [](const ImportedSurface& shown) {
        return tr("%1 closed").arg(edgesText(shown.report.closedSlitEdges));
    });
    show(m_filled, fills, [](const ImportedSurface& shown) { return filledText(shown.report); });
    show(m_left, closes || fills, leftText);
}

double OpeningOptions::slitWidth() const {
    return m_closes->isChecked() ? m_width->value().value_or(0) : 0;
}

std::size_t OpeningOptions::holeEdges() const {
    return m_fills->isChecked() ? static_cast<std::size_t>(m_edges->value().value_or(0)) : 0;
}

} // namespace esm
