#include "app/editor/panels/fuzzy/domains_panel.h"

#include "app/editor/dialogs/system_questions.h"
#include "app/editor/edits/selected_system.h"
#include "core/support/errors.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QResizeEvent>

#include <algorithm>

namespace esm {

namespace {

/// From here on the list of terms has its place beside the partition, pixels.
constexpr int besideWidth = 620;

QVBoxLayout* plainColumn(QWidget* widget) {
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    return column;
}

/// Held by hand, else inferred.
std::optional<double> outputOf(const Region& region, std::size_t output, double wallThickness) {
    const RegionTissue tissue = evaluate(region, wallThickness);
    const auto parameter = parameterOf(*region.system, output);
    const bool isHeld = parameter && valueOf(region.held, *parameter);
    return isHeld ? inTermsOf(region.system->outputs[output], *parameter, tissue.values, wallThickness)
                  : tissue.inference.outputs[output];
}

/// "5.500 kPa: flexible 0.92, medium 0.08"
QString valueInWords(const FuzzyVariable& variable, std::optional<double> value) {
    if (!value) return QObject::tr("no value now");
    return QStringLiteral("%1: %2").arg(withUnit(*value, QString::fromStdString(variable.unit)),
                                        wordsFor(variable, *value));
}

} // namespace

DomainsPanel::DomainsPanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_reach(reach),
      m_content(new QWidget(this)) {
    QVBoxLayout* column = plainColumn(this);
    column->addWidget(m_content, 1);
    buildContent();
    connectPartition();
    connectTerms();
    connectVariables();
    connect(&selection, &Selection::changed, this, &DomainsPanel::showSystem);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) follow(change.system);
    });
    connect(&reach, &SystemReach::changed, this, [this] { m_partition->setWaits(m_reach.wouldAsk()); });
}

void DomainsPanel::buildContent() {
    m_halves = new QBoxLayout(QBoxLayout::TopToBottom, m_content);
    m_halves->setContentsMargins(0, 0, 0, 0);
    m_halves->setSpacing(8);
    auto* drawn = new QWidget(m_content);
    QVBoxLayout* column = plainColumn(drawn);
    m_variables = new VariableChoice(drawn);
    m_words = new QLabel(drawn);
    m_words->setObjectName(QStringLiteral("domainWords"));
    m_words->setProperty("quiet", true);
    m_words->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_partition = new PartitionEditor(drawn);
    m_partition->setObjectName(QStringLiteral("partition"));
    m_corners = new CornerFields(drawn);
    m_corners->setObjectName(QStringLiteral("corners"));
    m_range = new RangeRow(drawn);
    m_range->setObjectName(QStringLiteral("range"));
    column->addWidget(m_variables);
    column->addWidget(m_words);
    column->addWidget(m_partition, 1);
    column->addWidget(m_corners);
    column->addWidget(m_range);
    m_halves->addWidget(drawn, 3);
    m_terms = new TermList(m_content);
    m_halves->addWidget(m_terms, 2);
}

void DomainsPanel::connectPartition() {
    const auto setCorners = [this](std::size_t term, const Trapezoid& set) {
        editVariable(
            tr("Shape term"), [&](FuzzyVariable& variable) { variable.terms[term].set = set; },
            EditKind::TermShape, term);
    };
    connect(m_partition, &PartitionEditor::termTaken, this, &DomainsPanel::takeTerm);
    connect(m_partition, &PartitionEditor::setEdited, this, setCorners);
    connect(m_partition, &PartitionEditor::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_corners, &CornerFields::cornerEdited, this, [this, setCorners](Corner corner, double value) {
        if (variable()) setCorners(m_term, withCorner(*variable(), m_term, corner, value));
    });
    connect(m_corners, &CornerFields::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_range, &RangeRow::rangeEdited, this, &DomainsPanel::setRange);
    connect(m_range, &RangeRow::gestureFinished, &m_document, &Document::finishGesture);
    connect(m_range, &RangeRow::unitEdited, this, [this](const std::string& unit) {
        editVariable(tr("Set unit"), [&](FuzzyVariable& variable) { variable.unit = unit; });
    });
}

void DomainsPanel::connectTerms() {
    connect(m_terms, &TermList::termTaken, this, &DomainsPanel::takeTerm);
    connect(m_terms, &TermList::termRenamed, this, &DomainsPanel::renameTerm);
    connect(m_terms, &TermList::removeRequested, this, &DomainsPanel::removeTerm);
    connect(m_terms, &TermList::moveRequested, this, &DomainsPanel::moveTerm);
    connect(m_terms, &TermList::addRequested, this, &DomainsPanel::addTerm);
    connect(m_terms, &TermList::evenRequested, this, [this] {
        editVariable(tr("Even partition"),
                     [](FuzzyVariable& variable) { variable.terms = evenPartition(variable); });
    });
    connect(m_terms, &TermList::overlapRequested, this, [this] {
        editVariable(tr("Overlap by half"),
                     [](FuzzyVariable& variable) { variable.terms = overlappedByHalf(variable); });
    });
}

void DomainsPanel::connectVariables() {
    connect(m_variables, &VariableChoice::chosen, this, &DomainsPanel::chooseVariable);
    connect(m_variables, &VariableChoice::addRequested, this, &DomainsPanel::addVariable);
    connect(m_variables, &VariableChoice::renameRequested, this, &DomainsPanel::renameVariable);
    connect(m_variables, &VariableChoice::removeRequested, this, &DomainsPanel::removeVariable);
    connect(m_variables, &VariableChoice::moveRequested, this, &DomainsPanel::moveVariable);
}

void DomainsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool beside = event->size().width() >= besideWidth;
    m_halves->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_halves->setSpacing(beside ? 18 : 8);
    m_terms->setTall(beside);
}

void DomainsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // The terms' colours in the list are those of the theme.
    if (event->type() == QEvent::PaletteChange) showSystem();
}

void DomainsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showSystem();
}

std::shared_ptr<const FuzzySystem> DomainsPanel::system() const {
    return selectedSystem(m_selection);
}

const FuzzyVariable* DomainsPanel::variable() const {
    const auto shown = system();
    return shown ? &variableAt(*shown, m_place) : nullptr;
}

/// What is edited stays in hand, also where it became a copy of another name.
void DomainsPanel::follow(const EditedSystem& edited) {
    const bool goesOn = sameValue(edited.before, m_shown) && sameValue(edited.after, system());
    if (goesOn && m_shown && m_selection.region() == m_shownRegion) {
        m_shown = system();
        m_terms->setProblems({});
    }
    showSystem();
}

void DomainsPanel::showSystem() {
    const auto shown = system();
    // What nobody looks at waits.
    if (!shown || !isVisible()) return;
    const std::size_t variables = variablesOf(*shown, m_place.side).size();
    if (m_place.index >= variables) m_place.index = variables - 1;
    const bool isOther = !m_shown || shown->name != m_shown->name || m_selection.region() != m_shownRegion;
    if (isOther) takeSpokenTerm();
    // What could not be done is of no interest where something else stands.
    if (isOther || shown != m_shown) m_terms->setProblems({});
    m_shown = shown;
    m_shownRegion = m_selection.region();
    m_term = std::min(m_term, variableAt(*shown, m_place).terms.size() - 1);
    m_variables->show(*shown, m_place);
    showVariable(*shown);
}

void DomainsPanel::showVariable(const FuzzySystem& system) {
    const FuzzyVariable& variable = variableAt(system, m_place);
    m_partition->setWaits(m_reach.wouldAsk());
    m_partition->setVariable(variable);
    m_partition->setTerm(m_term);
    const auto value = presentValue();
    m_partition->setValue(value);
    m_corners->setTerm(variable, m_term);
    m_range->setVariable(variable);
    m_words->setText(valueInWords(variable, value));
    m_terms->setTerms(variable, m_term, value);
}

std::optional<double> DomainsPanel::presentValue() const {
    const Region* shown = m_selection.selectedRegion();
    if (!shown || !system()) return std::nullopt;
    if (m_place.side == FuzzySide::Outputs)
        return outputOf(*shown, m_place.index, m_document.project().base.wallThickness);
    return valueOf(shown->inputs, variable()->name);
}

void DomainsPanel::chooseVariable(const VariablePlace& place) {
    m_document.finishGesture();
    m_place = place;
    m_terms->setProblems({});
    takeSpokenTerm();
    showSystem();
}

void DomainsPanel::takeSpokenTerm() {
    m_term = 0;
    const auto value = presentValue();
    if (!value) return;
    const auto& terms = variable()->terms;
    for (std::size_t i = 1; i < terms.size(); ++i)
        if (membership(terms[i].set, *value) > membership(terms[m_term].set, *value)) m_term = i;
}

void DomainsPanel::takeTerm(std::size_t term) {
    if (term == m_term) return;
    m_document.finishGesture();
    m_term = term;
    showSystem();
}

bool DomainsPanel::take(const QString& text, const SystemChange& change, EditKind kind, std::uint64_t place) {
    if (!system()) return false;
    const std::optional<Reach> reach = m_reach.ask();
    if (!reach) {
        showSystem();
        return false;
    }
    const RegionId region = *m_selection.region();
    try {
        m_document.edit(
            text, [&](Project& project) { change(project, *reach); }, {kind, region, place}, region);
        m_terms->setProblems({});
        return true;
    } catch (const InvalidModel& error) {
        m_terms->setProblems(error.problems());
        showSystem();
        return false;
    }
}

bool DomainsPanel::edit(const QString& text, const SystemEdit& change, EditKind kind, std::uint64_t place) {
    return take(
        text,
        [&](Project& project, Reach reach) {
            const RegionId region = *m_selection.region();
            editSystem(project, region, change(*partOf(project.regions, region).system), scopeOf(reach));
        },
        kind, place);
}

bool DomainsPanel::editVariable(const QString& text, const std::function<void(FuzzyVariable&)>& change,
                                EditKind kind, std::uint64_t place) {
    return edit(
        text,
        [&](const FuzzySystem& before) {
            FuzzyVariable variable = variableAt(before, m_place);
            change(variable);
            return withVariable(before, m_place, std::move(variable));
        },
        kind, place);
}

void DomainsPanel::setRange(double minimum, double maximum, TermsInRange terms) {
    take(
        tr("Set range"),
        [&](Project& project, Reach reach) {
            esm::setRange(project, *m_selection.region(), m_place, {minimum, maximum, terms}, scopeOf(reach));
        },
        EditKind::VariableRange);
}

void DomainsPanel::addTerm() {
    std::size_t added = 0;
    m_document.finishGesture();
    const auto add = [&](const FuzzySystem& before) {
        AddedTerm after = withTermAdded(before, m_place);
        added = after.term;
        return std::move(after.system);
    };
    if (!edit(tr("Add term"), add, EditKind::NewTerm)) return;
    m_term = added;
    showSystem();
    m_added = added;
    m_terms->askName(added);
}

void DomainsPanel::removeTerm() {
    const auto shown = system();
    if (!shown) return;
    const FuzzyVariable& from = variableAt(*shown, m_place);
    const QString name = QStringLiteral("“%1”").arg(readableName(from.terms[m_term].name));
    // The last one is refused without asking.
    if (from.terms.size() > 1 &&
        !mayTakeRulesAlong(*window(), *shown, name, rulesGoingWith(*shown, m_place, m_term)))
        return;
    edit(tr("Remove term"),
         [this](const FuzzySystem& before) { return withoutTerm(before, m_place, m_term); });
}

void DomainsPanel::moveTerm(int by) {
    const FuzzyVariable* shown = variable();
    const auto to = static_cast<std::ptrdiff_t>(m_term) + by;
    if (!shown || to < 0 || to >= static_cast<std::ptrdiff_t>(shown->terms.size())) return;
    const std::size_t from = m_term;
    m_term = static_cast<std::size_t>(to);
    const auto move = [&](const FuzzySystem& before) { return withTermMoved(before, m_place, from, m_term); };
    if (edit(tr("Reorder terms"), move)) return;
    m_term = from;
    showSystem();
}

void DomainsPanel::renameTerm(std::size_t term, const QString& typed) {
    // The name that a term is given first belongs to its adding.
    const EditKind kind = m_added == term ? EditKind::NewTerm : EditKind::Alone;
    m_added.reset();
    edit(
        tr("Rename term"),
        [&](const FuzzySystem& before) {
            return withTermRenamed(before, m_place, term, ruleName(typed.toStdString()));
        },
        kind);
    m_document.finishGesture();
    // A name that was not taken goes, and the old one comes back.
    QMetaObject::invokeMethod(
        this, [this] { showSystem(); }, Qt::QueuedConnection);
}

void DomainsPanel::addVariable(FuzzySide side) {
    const auto shown = system();
    if (!shown) return;
    const QString what = side == FuzzySide::Inputs ? tr("Add input") : tr("Add output");
    const VariablePlace place{side, variablesOf(*shown, side).size()};
    const auto name =
        askVariableName(*window(), what, variableAt(withVariableAdded(*shown, side), place).name);
    if (!name) return;
    const auto add = [&](const FuzzySystem& before) {
        FuzzySystem after = withVariableAdded(before, side);
        return variableAt(after, place).name == *name ? after : withVariableRenamed(after, place, *name);
    };
    if (edit(what, add)) chooseVariable(place);
}

void DomainsPanel::renameVariable() {
    const FuzzyVariable* shown = variable();
    if (!shown) return;
    const auto name = askVariableName(*window(), tr("Rename variable"), shown->name);
    if (!name) return;
    edit(tr("Rename variable"),
         [&](const FuzzySystem& before) { return withVariableRenamed(before, m_place, *name); });
}

void DomainsPanel::removeVariable() {
    const auto shown = system();
    if (!shown) return;
    const QString name = QStringLiteral("“%1”").arg(readableName(variableAt(*shown, m_place).name));
    if (variablesOf(*shown, m_place.side).size() > 1 &&
        !mayTakeRulesAlong(*window(), *shown, name, rulesGoingWith(*shown, m_place)))
        return;
    edit(tr("Remove variable"),
         [this](const FuzzySystem& before) { return withoutVariable(before, m_place); });
}

void DomainsPanel::moveVariable(int by) {
    const auto shown = system();
    const auto to = static_cast<std::ptrdiff_t>(m_place.index) + by;
    if (!shown || to < 0 || to >= static_cast<std::ptrdiff_t>(variablesOf(*shown, m_place.side).size()))
        return;
    const VariablePlace from = m_place;
    m_place.index = static_cast<std::size_t>(to);
    const auto move = [&](const FuzzySystem& before) {
        return withVariableMoved(before, from, m_place.index);
    };
    if (edit(tr("Reorder variables"), move)) return;
    m_place = from;
    showSystem();
}

} // namespace esm
