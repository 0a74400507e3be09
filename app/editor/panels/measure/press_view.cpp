#include "app/editor/panels/measure/press_view.h"

#include "app/editor/panels/measure/measurement_file.h"
#include "app/editor/panels/measure/test_charts.h"
#include "widgets/inputs/number_text.h"

#include <QVBoxLayout>

namespace esm {

namespace {

QString tableText(TestKind kind) {
    if (kind == TestKind::Strip)
        return PressView::tr("Write elongations, strains and forces as a table (.csv)");
    return kind == TestKind::Press ? PressView::tr("Write depths and forces as a table (.csv)")
                                   : PressView::tr("Write times, depths and forces as a table (.csv)");
}

QString millimetres(double metres) {
    return withUnit(1000 * metres, QStringLiteral("mm"), 3);
}

/// Of what was done to the organ.
QString sizeText(const MeasuredPress& test) {
    if (!test.strip) return PressView::tr("finger of radius %1").arg(millimetres(test.settings.radius));
    const StripSettings& strip = test.strip->settings;
    return PressView::tr("strip of %1 by %2").arg(millimetres(strip.length), millimetres(strip.width));
}

} // namespace

PressView::PressView(Document& document, VirtualTest& test, QWidget* parent)
    : QWidget(parent), m_document(document), m_test(test),
      m_header(new ComparisonHeader(QStringLiteral("Press"), this)), m_chart(new CurveChart(this)) {
    setObjectName(QStringLiteral("pressView"));
    setAttribute(Qt::WA_StyledBackground);
    m_chart->setObjectName(QStringLiteral("pressChart"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(8);
    column->addWidget(m_header);
    column->addWidget(m_chart, 1);
    connect(m_header, &ComparisonHeader::keepAsked, &m_test, &VirtualTest::keepLatest);
    connect(m_header, &ComparisonHeader::clearAsked, &m_test, &VirtualTest::forgetFormer);
    connect(m_header, &ComparisonHeader::tableAsked, this,
            [this] { tell(saveTable(window(), m_document, [this] { return testCsv(m_test); })); });
    connect(m_header, &ComparisonHeader::chartAsked, this,
            [this] { tell(saveChart(window(), m_document, [this] { return testDrawing(m_test); })); });
    connect(&m_test, &VirtualTest::changed, this, &PressView::refresh);
    showKind();
    refresh();
}

void PressView::tell(const QString& written) {
    if (!written.isEmpty()) emit message(written);
}

void PressView::showKind() {
    const TestChart chart = testChart(m_test.kind());
    m_shownKind = m_test.kind();
    m_chart->setAxes(chart.x, chart.y);
    m_chart->setToolTip(chart.toolTip);
    m_chart->setEmptyText(chart.empty);
}

void PressView::refresh() {
    if (m_test.kind() != m_shownKind) showKind();
    const VirtualTest::Press &now = m_test.latest(), &before = m_test.former();
    m_header->setState({now != nullptr, now != before, before != nullptr},
                       {tr("Draw every later test beside this one, also at another place or of another size"),
                        tr("Draw the last test alone"), tableText(m_test.kind()),
                        tr("This test is the one that the next is compared with"),
                        tr("There is no earlier test beside this one"), tr("Nothing is measured yet")});
    const QString title = testChart(m_test.kind()).title;
    m_header->setTitle(now ? title + QStringLiteral(", ") + sizeText(*now) : title);
    if (now == m_shown && before == m_shownBefore) return;
    m_shown = now;
    m_shownBefore = before;
    std::vector<ChartCurve> curves;
    if (now) curves.push_back(chartCurve(tr("now"), *now));
    if (before && before != now) curves.push_back(chartCurve(tr("before"), *before));
    m_chart->setCurves(std::move(curves));
}

} // namespace esm
