#include "app/editor/dialogs/opening_options.h"

#include "core/geometry/hole_filling.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

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

QLabel* quiet(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setProperty("quiet", true);
    return label;
}

QString edgesText(std::size_t count) {
    return count == 1 ? QObject::tr("1 edge") : QObject::tr("%1 edges").arg(countText(count));
}

QString inMillimetres(double metres) {
    return QObject::tr("%1 mm").arg(numberText(metres * 1000, 2));
}

double widest(const ImportedSurface& surface, LengthUnit unit) {
    return widestSlit(surface.extent.maxCoeff()) * metresPer(unit);
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

bool isSlit(const OpenBorder& border) {
    return std::isfinite(border.gap) && border.length > slitShape * border.gap;
}

} // namespace

OpeningOptions::OpeningOptions(std::shared_ptr<const ImportedSurface> found, LengthUnit unit, QWidget* parent)
    : QWidget(parent), m_found(std::move(found)), m_open(new QLabel(this)),
      m_closes(new QCheckBox(tr("&Close slits up to"), this)),
      m_fills(new QCheckBox(tr("&Fill holes of up to"), this)),
      m_width(new NumberField(widthFormat(widest(*m_found, unit)), this)),
      m_edges(new NumberField(edgesFormat(), this)), m_widthLimits(quiet(this)), m_closed(new QLabel(this)),
      m_filled(new QLabel(this)) {
    m_open->setObjectName(QStringLiteral("openBorders"));
    m_open->setWordWrap(true);
    m_closes->setObjectName(QStringLiteral("closesSlits"));
    m_fills->setObjectName(QStringLiteral("fillsHoles"));
    m_width->setObjectName(QStringLiteral("slitWidth"));
    m_edges->setObjectName(QStringLiteral("holeEdges"));
    m_closed->setObjectName(QStringLiteral("closedSlits"));
    m_filled->setObjectName(QStringLiteral("filledHoles"));
    m_width->setAccessibleName(tr("Width of slits to close"));
    m_edges->setAccessibleName(tr("Edges of holes to fill"));
    auto* edgesLimits = quiet(this);
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
        done->ensurePolished();
        done->setText(QStringLiteral("0"));
        done->setMinimumHeight(done->sizeHint().height());
    };
    addRow(1, m_closes, m_width, m_widthLimits, m_closed);
    addRow(3, m_fills, m_edges, edgesLimits, m_filled);
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
    m_width->setValue(std::clamp(m_isWidthTyped ? m_width->value().value_or(usualSlit) : proposedWidth(unit),
                                 leastWidth(most), most));
    m_widthLimits->setText(tr("at most %1").arg(inMillimetres(most)));
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
    const std::size_t edges = m_found->report.boundaryEdges;
    if (edges == 0) return tr("No open border");
    if (borders.empty()) return tr("%1 on open borders that are no loops").arg(edgesText(edges));
    const OpenBorder& largest = borders.front();
    const QString size = edgesText(largest.loop.size());
    QString text =
        borders.size() == 1
            ? tr("1 open border: %1").arg(size)
            : tr("%1 open borders, %2; the largest: %3").arg(borders.size()).arg(edgesText(edges), size);
    if (!std::isfinite(largest.gap)) return text;
    return tr("%1, its sides %2 apart").arg(text, inMillimetres(largest.gap * metresPer(unit)));
}

void OpeningOptions::showDone(const RepairReport* report) {
    const QString wait = QStringLiteral("…");
    m_closed->setText(!m_closes->isChecked() ? QString()
                      : report               ? tr("%1 closed").arg(edgesText(report->closedSlitEdges))
                                             : wait);
    m_filled->setText(!m_fills->isChecked() ? QString()
                      : report              ? tr("%1 filled").arg(countText(report->filledHoles))
                                            : wait);
}

double OpeningOptions::slitWidth() const {
    return m_closes->isChecked() ? m_width->value().value_or(0) : 0;
}

std::size_t OpeningOptions::holeEdges() const {
    return m_fills->isChecked() ? static_cast<std::size_t>(m_edges->value().value_or(0)) : 0;
}

} // namespace esm
