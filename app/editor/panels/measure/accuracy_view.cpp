#include "app/editor/panels/measure/accuracy_view.h"

#include "app/editor/panels/measure/measurement_file.h"
#include "app/editor/panels/measure/stepping_text.h"
#include "core/exchange/charts/measured_runs_csv.h"
#include "core/exchange/charts/tradeoff_chart.h"
#include "widgets/inputs/enabling.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace esm {

namespace {

/// With what the method does.
QString explainedText(const TradeoffRun& run) {
    return runText(run) + '\n' + methodText(run.stepping.integrator);
}

std::vector<AccuracyPoint> pointsOf(const Tradeoff& tradeoff) {
    std::vector<AccuracyPoint> points;
    points.reserve(tradeoff.runs.size());
    for (const TradeoffRun& run : tradeoff.runs)
        points.push_back({run.stable ? run.realTimeFactor() : 0, run.error, explainedText(run)});
    return points;
}

QString titleText(const Tradeoff* tradeoff) {
    if (!tradeoff) return AccuracyView::tr("Every method and step");
    const QString measured = AccuracyView::tr("%1 measured").arg(tradeoff->runs.size());
    if (tradeoff->leftOut.empty()) return AccuracyView::tr("Every method and step: %1").arg(measured);
    return AccuracyView::tr("Every method and step: %1, %2 left out")
        .arg(measured)
        .arg(tradeoff->leftOut.size());
}

} // namespace

AccuracyView::AccuracyView(Document& document, SpeedAndAccuracy& accuracy, QWidget* parent)
    : QWidget(parent), m_document(document), m_accuracy(accuracy), m_chart(new AccuracyChart),
      m_table(new RunsTable), m_both(new ChartAndTable(m_chart, m_table, this)),
      m_header(new QBoxLayout(QBoxLayout::LeftToRight)), m_title(new ElidedLabel(this)),
      m_onlyUnbeaten(new QCheckBox(tr("only the best"), this)), m_use(new QPushButton(tr("Use"), this)),
      m_exportTable(new QPushButton(tr("Save table…"), this)),
      m_exportChart(new QPushButton(tr("Save chart…"), this)) {
    setObjectName(QStringLiteral("accuracyView"));
    setAttribute(Qt::WA_StyledBackground);
    m_chart->setObjectName(QStringLiteral("accuracyChart"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(8);
    buildHeader();
    column->addLayout(m_header);
    column->addWidget(m_both, 1);

    connect(m_chart, &AccuracyChart::chosen, this, [this](std::size_t run) { use(run); });
    connect(m_chart, &AccuracyChart::marked, this, [this](std::size_t run) { mark(run); });
    connect(m_table, &RunsTable::chosen, this, [this](std::size_t run) { use(run); });
    connect(m_table, &RunsTable::markChanged, this, [this] { mark(m_table->marked()); });
    connect(m_onlyUnbeaten, &QCheckBox::toggled, this, [this](bool only) {
        // Rows that go take the mark along, and it stays in the chart.
        const QSignalBlocker quiet(m_table);
        m_table->setOnlyUnbeaten(only);
        m_table->mark(m_marked);
    });
    connect(m_both, &ChartAndTable::arranged, this, &AccuracyView::arrange);
    connect(&m_accuracy, &SpeedAndAccuracy::runsChanged, this, &AccuracyView::showRuns);
    connect(&m_accuracy, &SpeedAndAccuracy::changed, this, &AccuracyView::refresh);
    m_chart->setEmptyText(
        tr("Nothing is measured yet. Once it is, every method has a point here: the faster, the "
           "further right; the more exact, the lower."));
    showRuns();
    refresh();
}

void AccuracyView::buildHeader() {
    m_header->setSpacing(8);
    m_title->setProperty("quiet", true);
    m_header->addWidget(m_title, 1);
    auto* controls = new QHBoxLayout;
    controls->addWidget(m_both->tabs());
    controls->addStretch();
    m_header->addLayout(controls);
    m_onlyUnbeaten->setToolTip(tr("List those alone that no other beats in both speed and accuracy"));
    controls->addWidget(m_onlyUnbeaten);
    for (QPushButton* button : {m_use, m_exportTable, m_exportChart}) {
        button->setFocusPolicy(Qt::TabFocus);
        controls->addWidget(button);
    }
    connect(m_use, &QPushButton::clicked, this, [this] { use(m_marked); });
    connect(m_exportTable, &QPushButton::clicked, this, &AccuracyView::exportTable);
    connect(m_exportChart, &QPushButton::clicked, this, &AccuracyView::exportChart);
}

void AccuracyView::arrange() {
    m_header->setDirection(m_both->isNarrow() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    for (QWidget* control : std::initializer_list<QWidget*>{m_onlyUnbeaten, m_exportTable})
        control->setVisible(m_both->showsTable());
    m_exportChart->setVisible(m_both->showsChart());
}

void AccuracyView::showRuns() {
    const Tradeoff* tradeoff = m_accuracy.tradeoff();
    m_marked.reset();
    m_table->setTradeoff(tradeoff);
    m_chart->setPoints(tradeoff ? pointsOf(*tradeoff) : std::vector<AccuracyPoint>(),
                       tradeoff ? tradeoff->pareto : std::vector<std::size_t>());
}

void AccuracyView::refresh() {
    m_chart->setMostError(m_accuracy.wishes().mostError);
    m_chart->setChosen(m_accuracy.runInUse());
    m_table->setInUse(m_accuracy.runInUse());
    const bool isMeasured = m_accuracy.tradeoff() != nullptr;
    const QString none = tr("Nothing is measured yet");
    enable(m_exportTable, isMeasured, tr("Write every run as a table (.csv)"), none);
    enable(m_exportChart, isMeasured, tr("Write the chart as a picture (.png or .svg)"), none);
    showUse();
}

// Why a marked row cannot be used stands in sight, not in its tip alone.
void AccuracyView::showUse() {
    const Tradeoff* tradeoff = m_accuracy.tradeoff();
    const QString obstacle = m_marked ? m_table->obstacle(*m_marked) : QString();
    m_title->setText(obstacle.isEmpty() ? titleText(tradeoff) : obstacle);
    enable(m_use, isUsable(m_marked), tr("Let the tissue move by the method and step of the marked row"),
           !tradeoff  ? tr("Nothing is measured yet")
           : m_marked ? obstacle
                      : tr("Mark a row first"));
}

void AccuracyView::mark(std::optional<std::size_t> run) {
    m_marked = run;
    m_chart->mark(run);
    const QSignalBlocker quiet(m_table); // it may have no row for the run
    m_table->mark(run);
    showUse();
}

bool AccuracyView::isUsable(std::optional<std::size_t> run) const {
    const Tradeoff* tradeoff = m_accuracy.tradeoff();
    return run && *run < tradeoff->runs.size() && m_table->obstacle(*run).isEmpty();
}

void AccuracyView::use(std::optional<std::size_t> run) {
    if (isUsable(run)) m_accuracy.use(*run, window());
}

void AccuracyView::tell(const QString& written) {
    if (!written.isEmpty()) emit message(written);
}

void AccuracyView::exportTable() {
    tell(saveTable(window(), m_document, [this] { return measuredRunsCsv(*m_accuracy.tradeoff()); }));
}

void AccuracyView::exportChart() {
    tell(saveChart(window(), m_document,
                   [this] { return tradeoffChart(*m_accuracy.tradeoff(), m_accuracy.wishes()); }));
}

} // namespace esm
