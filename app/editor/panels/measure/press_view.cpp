#include "app/editor/panels/measure/press_view.h"

#include "app/editor/panels/measure/finger_charts.h"
#include "app/editor/panels/measure/measurement_file.h"
#include "core/exchange/charts/chart_file.h"
#include "core/support/atomic_file.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <QVariant>
#include <QVBoxLayout>

namespace esm {

namespace {

constexpr int roomForOneLine = 640; // pixels, of title and buttons

} // namespace

PressView::PressView(Document& document, VirtualTest& test, QWidget* parent)
    : QWidget(parent), m_document(document), m_test(test), m_header(new QBoxLayout(QBoxLayout::LeftToRight)),
      m_title(new ElidedLabel(this)), m_keep(new QPushButton(tr("Keep to compare"), this)),
      m_clear(new QPushButton(tr("Clear before"), this)),
      m_exportTable(new QPushButton(tr("Save table…"), this)),
      m_exportChart(new QPushButton(tr("Save chart…"), this)), m_chart(new CurveChart(this)) {
    setObjectName(QStringLiteral("pressView"));
    setAttribute(Qt::WA_StyledBackground);
    m_chart->setObjectName(QStringLiteral("pressChart"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(8);
    buildHeader();
    column->addLayout(m_header);
    column->addWidget(m_chart, 1);
    connect(&m_test, &VirtualTest::changed, this, &PressView::refresh);
    showKind();
    refresh();
}

void PressView::buildHeader() {
    m_header->setSpacing(8);
    m_title->setProperty("quiet", true);
    m_header->addWidget(m_title, 1);
    auto* controls = new QHBoxLayout;
    controls->addStretch();
    m_header->addLayout(controls);
    m_keep->setObjectName(QStringLiteral("keepPress"));
    m_clear->setObjectName(QStringLiteral("clearPress"));
    for (QPushButton* button : {m_keep, m_clear, m_exportTable, m_exportChart}) {
        button->setFocusPolicy(Qt::TabFocus);
        controls->addWidget(button);
    }
    connect(m_keep, &QPushButton::clicked, &m_test, &VirtualTest::keepLatest);
    connect(m_clear, &QPushButton::clicked, &m_test, &VirtualTest::forgetFormer);
    connect(m_exportTable, &QPushButton::clicked, this, &PressView::exportTable);
    connect(m_exportChart, &QPushButton::clicked, this, &PressView::exportChart);
}

void PressView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_header->setDirection(width() < roomForOneLine ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void PressView::showKind() {
    const FingerChart chart = fingerChart(m_test.kind());
    m_shownKind = m_test.kind();
    m_chart->setAxes(chart.x, chart.y);
    m_chart->setToolTip(chart.toolTip);
    m_chart->setEmptyText(chart.empty);
}

void PressView::refresh() {
    if (m_test.kind() != m_shownKind) showKind();
    const VirtualTest::Press &now = m_test.latest(), &before = m_test.former();
    const QString none = tr("Nothing is measured yet");
    enable(m_keep, now && now != before,
           tr("Draw every later test beside this one, also at another place or with another finger"),
           now ? tr("This test is the one that the next is compared with") : none);
    enable(m_clear, before != nullptr, tr("Draw the last test alone"),
           tr("There is no earlier test beside this one"));
    enable(m_exportTable, now != nullptr,
           m_test.kind() == FingerTest::Press ? tr("Write depths and forces as a table (.csv)")
                                              : tr("Write times, depths and forces as a table (.csv)"),
           none);
    enable(m_exportChart, now != nullptr, tr("Write the chart as a picture (.png or .svg)"), none);
    const QString title = fingerChart(m_test.kind()).title;
    m_title->setText(now ? tr("%1, finger of radius %2")
                               .arg(title, withUnit(1000 * now->settings.radius, QStringLiteral("mm"), 3))
                         : title);
    if (now == m_shown && before == m_shownBefore) return;
    m_shown = now;
    m_shownBefore = before;
    std::vector<ChartCurve> curves;
    if (now) curves.push_back(chartCurve(tr("now"), *now));
    if (before && before != now) curves.push_back(chartCurve(tr("before"), *before));
    m_chart->setCurves(std::move(curves));
}

void PressView::exportTable() {
    const QString written = writeMeasurement(
        window(), fileForOthers(m_document, tr("Save table"), tr("Tables (*.csv)"), {QStringLiteral(".csv")}),
        tr("The table was not written"),
        [this](const std::filesystem::path& file) { writeFileAtomically(file, fingerCsv(m_test)); });
    if (!written.isEmpty()) emit message(written);
}

void PressView::exportChart() {
    const QString written =
        writeMeasurement(window(),
                         fileForOthers(m_document, tr("Save chart"), tr("Pictures (*.png);;Drawings (*.svg)"),
                                       {QStringLiteral(".png"), QStringLiteral(".svg")}),
                         tr("The chart was not written"), [this](const std::filesystem::path& file) {
                             writeChart(fingerDrawing(m_test), file);
                         });
    if (!written.isEmpty()) emit message(written);
}

} // namespace esm
