#include "app/editor/panels/fuzzy/why_panel.h"

#include "app/editor/edits/input_edits.h"
#include "app/editor/panels/parameter_row.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/spoken.h"

#include <QHBoxLayout>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace esm {

namespace {

constexpr int widthForTwo = 640; ///< pixels, for two parts beside each other
constexpr std::chrono::milliseconds patienceWithOld{250};

QString outputUnit(const FuzzySystem& system, std::size_t output) {
    const FuzzyVariable& variable = system.outputs[output];
    const auto parameter = parameterOf(system, output);
    return parameter && !isInClinicalUnits(system, output) ? parameterFormat(*parameter).unit
                                                           : QString::fromStdString(variable.unit);
}

QLabel* quietText(const QString& text) {
    auto* label = new QLabel(text);
    label->setProperty("quiet", true);
    label->setWordWrap(true);
    return label;
}

QComboBox* whyChooser(const char* name, const QString& accessibleName) {
    auto* combo = new QComboBox;
    guardFromWheel(*combo);
    combo->setObjectName(QString::fromLatin1(name));
    nameChoice(*combo, accessibleName);
    combo->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    return combo;
}

void fillChooser(QComboBox* combo, const std::vector<FuzzyVariable>& variables) {
    const QString before = combo->currentText();
    const QSignalBlocker quiet(combo);
    combo->clear();
    for (const FuzzyVariable& variable : variables)
        combo->addItem(readableName(variable.name));
    combo->setCurrentIndex(std::max(0, combo->findText(before)));
}

/// A view beneath its quiet title.
QWidget* titledPart(const QString& title, QWidget* view, QWidget* besideTitle = nullptr) {
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    auto* row = new QHBoxLayout;
    row->addWidget(quietText(title), 1);
    if (besideTitle) row->addWidget(besideTitle);
    column->addLayout(row);
    column->addWidget(view, 1);
    return part;
}

std::size_t chosenIndex(const QComboBox* combo) {
    return static_cast<std::size_t>(std::max(0, combo->currentIndex()));
}

} // namespace

WhyPanel::WhyPanel(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_failure(quietText({})),
      m_choices(new QWidget), m_content(new QWidget), m_output(whyChooser("whyOutput", tr("Output"))),
      m_across(whyChooser("whyAcross", tr("Input of the curve"))),
      m_up(whyChooser("whyUp", tr("Second input of the map"))), m_rules(new RuleStrengths),
      m_conclusion(new ConclusionView), m_curve(new ResponseCurveView), m_map(new ResponseMapView),
      m_noMap(quietText(tr("No map: it needs two inputs, and this system has one."))),
      m_grid(new QGridLayout(m_content)) {
    setObjectName(QStringLiteral("whyPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_choices);
    column->addWidget(m_failure, 0, Qt::AlignTop);
    m_failure->setObjectName(QStringLiteral("whyFailure"));
    m_failure->hide();
    column->addWidget(m_content, 1);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(8);
    buildChoices();
    buildViews();
    arrange();
    m_wait.setSingleShot(true);
    m_wait.setInterval(patienceWithOld);
    connect(&m_wait, &QTimer::timeout, this, [this] { showStale(m_finder.answer()); });
    connect(&m_finder, &ExplanationFinder::found, this, &WhyPanel::showAnswer);
    connect(&selection, &Selection::changed, this, &WhyPanel::showSystem);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.regions || change.mesh) showSystem();
    });
    showSystem();
}

void WhyPanel::buildChoices() {
    auto* rows = new QGridLayout(m_choices);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(6);
    rows->addWidget(quietText(tr("Output")), 0, 0);
    rows->addWidget(m_output, 0, 1);
    rows->addWidget(quietText(tr("over")), 1, 0);
    rows->addWidget(m_across, 1, 1);
    rows->addWidget(quietText(tr("and")), 2, 0);
    rows->addWidget(m_up, 2, 1);
    rows->setColumnStretch(1, 1);
    m_output->setToolTip(tr("The output that is explained"));
    m_across->setToolTip(tr("The input that the curve goes over, and the map across"));
    for (QComboBox* choice : {m_output, m_across, m_up})
        connect(choice, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, choice] {
            if (choice != m_output) keepApart(choice);
            chooseAxes();
            ask();
        });
}

void WhyPanel::buildViews() {
    auto* sorted = new QToolButton;
    sorted->setObjectName(QStringLiteral("headerButton"));
    sorted->setText(tr("strongest first"));
    sorted->setToolTip(tr("Strongest first, or in the order of the system"));
    sorted->setCheckable(true);
    sorted->setChecked(true);
    sorted->setFocusPolicy(Qt::TabFocus);
    connect(sorted, &QToolButton::toggled, m_rules, [this, sorted](bool on) {
        sorted->setText(on ? tr("strongest first") : tr("in their order"));
        m_rules->setStrongestFirst(on);
    });
    connect(m_rules, &RuleStrengths::ruleChosen, m_conclusion,
            [this] { m_conclusion->setChosenRule(m_rules->chosenRule()); });
    auto* maps = new QWidget;
    auto* mapColumn = new QVBoxLayout(maps);
    mapColumn->setContentsMargins(0, 0, 0, 0);
    mapColumn->addWidget(m_noMap, 0, Qt::AlignTop);
    mapColumn->addWidget(m_map);
    m_parts = {titledPart(tr("How strongly the rules fire"), m_rules, sorted),
               titledPart(tr("What they conclude, and its centre of gravity"), m_conclusion),
               titledPart(tr("The output over one input"), m_curve),
               titledPart(tr("The output over two inputs"), maps)};
    for (const ResponseView* view :
         {static_cast<ResponseView*>(m_curve), static_cast<ResponseView*>(m_map)}) {
        connect(view, &ResponseView::inputsSet, this, &WhyPanel::setInputs);
        connect(view, &ResponseView::gestureFinished, &m_document, &Document::finishGesture);
    }
}

void WhyPanel::arrange() {
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        const int place = static_cast<int>(i);
        m_grid->removeWidget(m_parts[i]);
        if (m_isWide)
            m_grid->addWidget(m_parts[i], place % 2, place / 2);
        else
            m_grid->addWidget(m_parts[i], place, 0);
    }
    for (int column = 0; column < 2; ++column)
        m_grid->setColumnStretch(column, column == 0 || m_isWide ? 1 : 0);
}

void WhyPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool isWide = width() >= widthForTwo;
    if (isWide == m_isWide) return;
    m_isWide = isWide;
    arrange();
}

void WhyPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showSystem();
}

const Region* WhyPanel::region() const {
    return m_selection.selectedRegion();
}

void WhyPanel::showSystem() {
    const Region* shown = region();
    const std::shared_ptr<const FuzzySystem> system = shown ? shown->system : nullptr;
    // What nobody looks at waits.
    if (!isVisible()) return;
    if (system != m_system) {
        m_system = system;
        rebuild();
    }
    ask();
}

void WhyPanel::rebuild() {
    m_rules->setSystem(m_system);
    if (!m_system) return;
    fillChooser(m_output, m_system->outputs);
    fillChooser(m_across, m_system->inputs);
    fillChooser(m_up, m_system->inputs);
    const bool hasMap = m_system->inputs.size() > 1;
    if (hasMap && m_up->currentIndex() == m_across->currentIndex()) {
        const QSignalBlocker quiet(m_up);
        m_up->setCurrentIndex((m_across->currentIndex() + 1) % m_up->count());
    }
    m_up->setEnabled(hasMap);
    m_up->setToolTip(hasMap ? tr("The input that the map goes up with") : m_noMap->text());
    m_map->setVisible(hasMap);
    m_noMap->setVisible(!hasMap);
    chooseAxes();
}

/// The two inputs of a map are not the same: where one is given the other's place, they swap.
void WhyPanel::keepApart(const QComboBox* changed) {
    if (m_up->count() < 2 || m_up->currentIndex() != m_across->currentIndex()) return;
    QComboBox* other = changed == m_up ? m_across : m_up;
    const QSignalBlocker quiet(other);
    other->setCurrentIndex(changed == m_up ? m_shownUp : m_shownAcross);
}

void WhyPanel::chooseAxes() {
    m_shownAcross = m_across->currentIndex();
    m_shownUp = m_up->currentIndex();
    const FuzzyVariable &output = m_system->outputs[chosenIndex(m_output)],
                        &across = m_system->inputs[chosenIndex(m_across)],
                        &up = m_system->inputs[chosenIndex(m_up)];
    const QString unit = outputUnit(*m_system, chosenIndex(m_output));
    const auto [low, high] = usualValues(*m_system, chosenIndex(m_output));
    m_conclusion->setOutput(output, unit);
    m_conclusion->setExplanation({});
    m_curve->setAxes(across, output, {low, high, unit});
    m_map->setAxes({across, up, output, {low, high, unit}});
    m_shownCurve.reset();
    m_shownMap.reset();
    m_axesAsked = m_asked + 1;
}

void WhyPanel::ask() {
    const Region* shown = region();
    if (!m_system || !shown) return;
    const auto inputs = orderedInputs(*m_system, shown->inputs);
    const std::optional<double> across = inputs[chosenIndex(m_across)];
    m_curve->setInputs(across, std::nullopt);
    m_map->setInputs(across, inputs[chosenIndex(m_up)]);
    WhyQuestion question{m_system, {chosenIndex(m_output), inputs}, chosenIndex(m_across), std::nullopt};
    if (m_system->inputs.size() > 1) question.up = chosenIndex(m_up);
    m_asked = m_finder.ask(question);
    if (!m_wait.isActive()) m_wait.start();
}

/// The value held by hand in place of the chosen output, in its terms.
std::optional<double> WhyPanel::heldOutput() const {
    const FuzzyVariable& output = m_system->outputs[chosenIndex(m_output)];
    const auto parameter = parameterOf(*m_system, chosenIndex(m_output));
    if (!parameter || !valueOf(region()->held, *parameter)) return std::nullopt;
    const double wallThickness = m_document.project().base.wallThickness;
    return inTermsOf(output, *parameter, evaluate(*region(), wallThickness).values, wallThickness);
}

void WhyPanel::showAnswer() {
    const WhyAnswer answer = m_finder.answer();
    if (!m_system || !region()) return;
    const bool hasFailed = answer.failed == m_asked;
    m_failure->setVisible(hasFailed);
    m_content->setVisible(!hasFailed);
    if (hasFailed) m_failure->setText(tr("This cannot be explained: %1").arg(answer.failure));
    if (answer.explained < m_axesAsked) return;
    m_rules->setExplanations(answer.rules);
    const std::optional<double> present = answer.output.value;
    m_conclusion->setExplanation(answer.output);
    m_conclusion->setHeld(heldOutput());
    m_curve->setPresent(answer.inputs[chosenIndex(m_across)], std::nullopt, present);
    m_map->setPresent(answer.inputs[chosenIndex(m_across)], answer.inputs[chosenIndex(m_up)], present);
    if (answer.drawn >= m_axesAsked && answer.curve != m_shownCurve) {
        m_shownCurve = answer.curve;
        m_curve->setCurve(*m_shownCurve);
    }
    if (answer.map && answer.mapped >= m_axesAsked && answer.map != m_shownMap) {
        m_shownMap = answer.map;
        m_map->setMap(*m_shownMap);
    }
    m_complete = answer.complete;
    if (isUpToDate()) m_wait.stop();
    if (!m_wait.isActive()) showStale(answer);
}

void WhyPanel::showStale(const WhyAnswer& answer) {
    m_curve->setStale(answer.drawn < m_asked);
    m_map->setStale(answer.mapped < m_asked);
}

void WhyPanel::setInputs(std::optional<double> across, std::optional<double> up) {
    const auto selected = m_selection.region();
    if (!selected || !m_system) return;
    NamedValues inputs;
    const auto add = [&](const QComboBox* choice, std::optional<double> value) {
        const FuzzyVariable& input = m_system->inputs[chosenIndex(choice)];
        if (value) inputs.emplace_back(input.name, std::clamp(*value, input.minimum, input.maximum));
    };
    add(m_across, across);
    add(m_up, up);
    editInputs(m_document, *selected, inputs);
}

} // namespace esm
