#include "app/editor/panels/organ/accuracy_panel.h"

#include "app/editor/dialogs/attempt.h"
#include "app/editor/dialogs/long_work.h"
#include "app/editor/edits/simulated_edit.h"
#include "app/editor/panels/organ/stepping_text.h"
#include "core/authoring/accuracy.h"
#include "core/authoring/coarser_runs.h"
#include "core/model/tissue_digest.h"
#include "core/project/detail_change.h"
#include "core/support/errors.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"
#include "widgets/inputs/quantity_formats.h"

#include <QScrollArea>

#include <algorithm>

namespace esm {

namespace {

constexpr double secondsPerWay = 1; ///< of computing; a way to step that takes longer is left out

/// To evaluate the tissue at every step of a drag would hold the drag up.
constexpr int restBeforeComparing = 300; // ms

/// The tissue rests meanwhile: its motion would take time from what is measured.
class Pause {
public:
    explicit Pause(Preview& preview) : m_preview(preview), m_wasPlaying(preview.status().playing) {
        m_preview.setPlaying(false);
    }
    ~Pause() { m_preview.setPlaying(m_wasPlaying); }
    Pause(const Pause&) = delete;
    Pause& operator=(const Pause&) = delete;

private:
    Preview& m_preview;
    bool m_wasPlaying;
};

/// A part of the motion, in percent.
QString figuresText(double realTimeFactor, double error) {
    return QObject::tr("%1× real time, %2 % error")
        .arg(numberText(realTimeFactor, 2), numberText(100 * error, 2));
}

QString figuresText(const TradeoffRun& run) {
    const double speed = run.realTimeFactor();
    return run.isErrorBound ? QObject::tr("%1× real time, at most %2 % error")
                                  .arg(numberText(speed, 2), numberText(100 * run.error, 2))
                            : figuresText(speed, run.error);
}

/// "split2, step 8.4 ms", and the number of nodes where they are fewer than the project's.
QString wayText(const TradeoffRun& run) {
    const QString text = steppingText(run.stepping);
    return run.coarser ? QObject::tr("%1, %2 nodes").arg(text, countText(run.nodes)) : text;
}

QString runText(const TradeoffRun& run) {
    return wayText(run) + '\n' + figuresText(run);
}

/// With what the method does.
QString explainedText(const TradeoffRun& run) {
    return runText(run) + '\n' + methodText(run.stepping.integrator);
}

/// Brings a part of a column into view.
void scrollTo(QWidget& part) {
    for (QWidget* around = part.parentWidget(); around; around = around->parentWidget())
        if (auto* column = qobject_cast<QScrollArea*>(around)) return column->ensureWidgetVisible(&part, 0);
}

std::vector<AccuracyPoint> pointsOf(const Tradeoff& tradeoff) {
    std::vector<AccuracyPoint> points;
    points.reserve(tradeoff.runs.size());
    for (const TradeoffRun& run : tradeoff.runs)
        points.push_back({run.stable ? run.realTimeFactor() : 0, run.error, explainedText(run)});
    return points;
}

} // namespace

AccuracyPanel::AccuracyPanel(Document& document, Preview& preview, QWidget* parent)
    : Section(tr("Speed and accuracy"), parent), m_document(document), m_preview(preview),
      m_measure(
          addHeaderButton(tr("measure"), tr("Compute the motion by every method and step, and compare"))),
      m_inUse(new QLabel(this)), m_automatic(new QToolButton(this)), m_hint(new QLabel(this)),
      m_measured(buildMeasured()) {
    m_inUse->setObjectName(QStringLiteral("steppingInUse"));
    m_hint->setObjectName(QStringLiteral("accuracyHint"));
    m_hint->setProperty("quiet", true);
    m_hint->setWordWrap(true);
    m_automatic->setText(tr("automatic"));
    m_automatic->setObjectName(QStringLiteral("quietButton"));
    m_automatic->setFocusPolicy(Qt::TabFocus);
    auto* inUse = new QHBoxLayout;
    inUse->addWidget(m_inUse, 1);
    inUse->addWidget(m_automatic);
    body()->addLayout(inUse);
    body()->addWidget(m_hint);
    body()->addWidget(m_measured);

    connect(m_measure, &QToolButton::clicked, this, &AccuracyPanel::measure);
    connect(m_automatic, &QToolButton::clicked, this, &AccuracyPanel::useAutomatic);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restBeforeComparing);
    connect(&m_rest, &QTimer::timeout, this, &AccuracyPanel::compareTissue);
    connect(&preview, &Preview::tissueReady, &m_rest, qOverload<>(&QTimer::start));
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.model() || change.stepping) m_rest.start();
        refresh();
    });
    m_rest.start();
    refresh();
}

QWidget* AccuracyPanel::buildMeasured() {
    auto* measured = new QWidget(this);
    m_chart = new AccuracyChart(measured);
    m_chart->setObjectName(QStringLiteral("accuracyChart"));
    m_mostError = new NumberField(percentFormat(1e-9, 1), measured);
    m_mostError->setObjectName(QStringLiteral("mostError"));
    m_mostError->setToolTip(tr("How far the motion may be off, as a part of the motion itself"));
    m_mostError->setValue(TradeoffWishes().mostError);
    m_inRealTime = new QPushButton(measured);
    m_inRealTime->setObjectName(QStringLiteral("inRealTime"));
    m_toError = new QPushButton(measured);
    m_toError->setObjectName(QStringLiteral("toError"));
    for (QPushButton* button : {m_inRealTime, m_toError}) // no wider than the column, whatever they say
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);

    auto* rows = new ValueRows(measured);
    rows->addWideField(tr("In real time, with the least error"), m_inRealTime);
    rows->addField(tr("Err&or at most"), m_mostError);
    rows->addWideField(tr("Within that error, the fastest"), m_toError);
    auto* column = new QVBoxLayout(measured);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_chart);
    column->addWidget(rows);

    connect(m_chart, &AccuracyChart::chosen, this, &AccuracyPanel::use);
    connect(m_mostError, &NumberField::valueEdited, this, &AccuracyPanel::showRecommendations);
    connect(m_inRealTime, &QPushButton::clicked, this,
            [this] { use(*m_measurement->tradeoff.bestInRealTime); });
    connect(m_toError, &QPushButton::clicked, this, [this] { use(*m_measurement->tradeoff.fastestToError); });
    return measured;
}

void AccuracyPanel::measure() {
    const Project project = m_document.project();
    TradeoffOptions options;
    options.mostSecondsPerRun = secondsPerWay;
    options.wishes.mostError = *m_mostError->value();
    attempt(window(), tr("Speed and accuracy cannot be measured"), [&] {
        const Pause pause(m_preview);
        Tradeoff measured;
        runLongWork(
            window(), tr("Measuring speed and accuracy"),
            [&](const Progress& progress) { measured = measureAccuracy(project, options, progress); },
            Cancelling::Offered);
        m_measurement = {project, std::move(measured), {}};
        showMeasurement();
        refresh();
        // It has its place only when the column was laid out anew.
        QTimer::singleShot(0, this, [this] { scrollTo(*m_measured); });
    });
}

bool AccuracyPanel::isMeasured() const {
    return m_measurement && m_measurement->project.mesh == m_document.project().mesh;
}

bool AccuracyPanel::isOutdated() const {
    if (!isMeasured()) return false;
    const auto isNow = [this](const Project& project) {
        return !difference(project, m_document.project()).model();
    };
    const auto& fewer = m_measurement->onFewerNodes;
    return !isNow(m_measurement->project) && std::none_of(fewer.begin(), fewer.end(), isNow);
}

/// A project may be on the fewer nodes of a run that was chosen before.
Project AccuracyPanel::onMeasuredNodes(Project project, Tissue tissue) const {
    const Project& measured = m_measurement->project;
    if (tissue == Tissue::Other) {
        const bool isOnThem = project.network->restPositions.size() == measured.network->restPositions.size();
        return isOnThem ? project : withDetail(project, detailOf(*measured.network));
    }
    project.network = measured.network;
    project.scene = measured.scene;
    return project;
}

void AccuracyPanel::compareTissue() {
    const std::optional<MeasuredStepping>& stepping = m_document.project().stepping;
    const std::shared_ptr<const TissueModel> tissue = m_preview.tissue();
    // Until it is evaluated, what was said before stays; where it cannot be, the preview says what is wrong.
    if (tissue || !stepping) m_isFromOtherTissue = stepping && isFromOtherTissue(*stepping, *tissue);
    refresh();
}

void AccuracyPanel::refresh() {
    m_measured->setVisible(isMeasured());
    m_measure->setText(isMeasured() ? tr("measure again") : tr("measure"));
    const bool hidesSwings = isMeasured() && m_measurement->tradeoff.reference.hidesSwings;
    const bool hasChanged = isOutdated() || (m_document.project().stepping && m_isFromOtherTissue);
    m_hint->setVisible(!isMeasured() || hasChanged || hidesSwings);
    m_hint->setText(hasChanged ? tr("Tissue or scene have changed since: measure again to be sure.")
                    : hidesSwings
                        ? tr("Fast swings of tissue with next to no viscosity could not be "
                             "followed: no error here contains them.")
                        : tr("How fast and how exactly can this machine compute the motion? Measure "
                             "every method, then choose one."));
    showInUse();
}

void AccuracyPanel::showInUse() {
    const auto& inUse = m_document.project().stepping;
    m_inUse->setText(inUse ? steppingText(inUse->stepping) + '\n' +
                                 figuresText(1 / inUse->wallPerSimulatedSecond, inUse->error)
                           : tr("Method and step\nchosen by the program"));
    m_inUse->setToolTip(inUse ? methodText(inUse->stepping.integrator) : QString());
    enable(m_automatic, inUse.has_value(), tr("Let the program choose method and step again"),
           tr("The program already chooses method and step"));
    if (!isMeasured()) return;
    const auto& runs = m_measurement->tradeoff.runs;
    const std::size_t nodes = m_document.project().network->restPositions.size();
    const auto marked = std::find_if(runs.begin(), runs.end(), [&](const TradeoffRun& run) {
        return inUse && run.nodes == nodes && run.stepping == inUse->stepping;
    });
    m_chart->setChosen(marked == runs.end() ? std::nullopt
                                            : std::optional<std::size_t>(marked - runs.begin()));
}

void AccuracyPanel::showMeasurement() {
    const Tradeoff& tradeoff = m_measurement->tradeoff;
    m_chart->setPoints(pointsOf(tradeoff), tradeoff.pareto);
    showRecommendations();
}

void AccuracyPanel::showRecommendations() {
    if (!m_measurement) return;
    TradeoffWishes wishes;
    wishes.mostError = *m_mostError->value();
    Tradeoff& tradeoff = m_measurement->tradeoff;
    recommend(tradeoff, wishes);
    m_chart->setMostError(wishes.mostError);
    showRecommendation(m_inRealTime, tradeoff.bestInRealTime, tr("None is as fast as real time"));
    showRecommendation(m_toError, tradeoff.fastestToError, tr("None is as exact"));
}

void AccuracyPanel::showRecommendation(QPushButton* button, std::optional<std::size_t> run,
                                       const QString& none) {
    button->setText(run ? runText(m_measurement->tradeoff.runs[*run]) : none);
    enable(button, run.has_value(), tr("Use this method and step"), none);
}

void AccuracyPanel::use(std::size_t index) {
    const TradeoffRun& run = m_measurement->tradeoff.runs[index];
    const Project project = m_document.project();
    attempt(window(), tr("This setting cannot be used"), [&] {
        const Tissue tissue = isOutdated() ? Tissue::Other : Tissue::Measured;
        const Project changed = computeLong(window(), tr("Choosing method and step"), [&](const Progress&) {
            return withRun(onMeasuredNodes(project, tissue), run);
        });
        if (tissue == Tissue::Measured && run.coarser) m_measurement->onFewerNodes.push_back(changed);
        m_document.edit(tr("Choose method and step"),
                        [&](Project& edited) { takeSimulated(edited, changed); });
    });
}

void AccuracyPanel::useAutomatic() {
    m_document.edit(tr("Choose method and step"), [](Project& project) { project.stepping.reset(); });
}

} // namespace esm
