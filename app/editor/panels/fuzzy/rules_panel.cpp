#include "app/editor/panels/fuzzy/rules_panel.h"

#include "app/editor/edits/selected_system.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/number_text.h"

#include <QButtonGroup>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace esm {

namespace {

constexpr std::size_t mostNotes = 50; // more mistakes than anyone mends at once
/// More are compared with each other when nobody types.
constexpr std::size_t mostRulesCheckedAtOnce = 100;

QString rulesCounted(std::size_t count) {
    return count == 1 ? QObject::tr("1 rule") : QObject::tr("%1 rules").arg(countText(count));
}

QPushButton* switchButton(const QString& text, const QString& toolTip, QButtonGroup* group) {
    auto* button = new QPushButton(text);
    button->setObjectName(QStringLiteral("quietButton"));
    button->setToolTip(toolTip);
    button->setCheckable(true);
    group->addButton(button);
    return button;
}

QPushButton* quietButton(const QString& text) {
    auto* button = new QPushButton(text);
    button->setObjectName(QStringLiteral("quietButton"));
    return button;
}

} // namespace

RulesPanel::RulesPanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_reach(reach),
      m_views(new QStackedWidget), m_text(new RuleTextEdit), m_table(new RuleTable), m_state(new QLabel),
      m_notes(new RuleNotes), m_rest(new QTimer(this)), m_check(new QTimer(this)) {
    m_text->setObjectName(QStringLiteral("ruleText"));
    m_table->setObjectName(QStringLiteral("ruleTable"));
    m_views->addWidget(m_text);
    m_views->addWidget(m_table);
    m_views->setMinimumHeight(210);
    m_state->setObjectName(QStringLiteral("ruleState"));
    m_state->setWordWrap(true);
    m_state->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_state->setFixedHeight(4 * m_state->fontMetrics().lineSpacing() + 2);
    m_notes->setFixedHeight(5 * m_notes->fontMetrics().lineSpacing());

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(buildTop());
    column->addWidget(m_state);
    column->addWidget(m_views, 1);
    column->addWidget(m_notes);

    connectParts();
    follow();
}

void RulesPanel::connectParts() {
    m_rest->setSingleShot(true);
    m_rest->setInterval(3000);
    m_check->setSingleShot(true);
    m_check->setInterval(1000);
    connect(m_rest, &QTimer::timeout, this, &RulesPanel::finishRun);
    connect(m_check, &QTimer::timeout, this, &RulesPanel::check);
    connect(m_text, &RuleTextEdit::edited, this, &RulesPanel::takeText);
    connect(m_text, &RuleTextEdit::left, this, &RulesPanel::finishRun);
    connect(m_text, &RuleTextEdit::undoRequested, this, &RulesPanel::undo);
    connect(m_text, &RuleTextEdit::redoRequested, this, &RulesPanel::redo);
    connect(m_text, &RuleTextEdit::pasteRefused, this, [this](const QString& why) {
        m_refusal = why;
        showNotes();
    });
    connect(m_table, &RuleTable::edited, this, &RulesPanel::takeTable);
    connect(m_table, &RuleTable::undoRequested, this, &RulesPanel::undo);
    connect(m_table, &RuleTable::redoRequested, this, &RulesPanel::redo);
    connect(m_notes, &RuleNotes::placePicked, this, &RulesPanel::goTo);
    connect(&m_selection, &Selection::changed, this, [this] { follow(); });
    connect(&m_document, &Document::changed, this, [this](const Change& change) {
        if (change.mesh || change.regions) follow(change.system);
    });
}

QWidget* RulesPanel::buildTop() {
    auto* top = new QWidget;
    auto* group = new QButtonGroup(this);
    m_asText = switchButton(tr("Text"), tr("Read and write the rules as text"), group);
    m_asTable = switchButton(tr("Table"), tr("The same rules as a table, in which words are chosen"), group);
    m_apply = quietButton(tr("Apply"));
    m_putBack = quietButton(tr("Put back"));
    auto* row = new QHBoxLayout(top);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_asText);
    row->addWidget(m_asTable);
    row->addStretch();
    row->addWidget(m_apply);
    row->addWidget(m_putBack);
    m_asText->setChecked(true);
    connect(m_asTable, &QAbstractButton::toggled, this, [this](bool table) {
        finishRun();
        m_views->setCurrentWidget(table ? static_cast<QWidget*>(m_table) : m_text);
        showTable();
    });
    connect(m_apply, &QAbstractButton::clicked, this, [this] {
        apply();
        finishRun();
    });
    connect(m_putBack, &QAbstractButton::clicked, this, &RulesPanel::putBack);
    return top;
}

void RulesPanel::follow(const EditedSystem& edited) {
    leaveOrgan();
    m_drafts.follow(edited);
    const auto system = selectedSystem(m_selection);
    const bool goesOn = m_system && (sameValue(system, m_system) ||
                                     (sameValue(edited.before, m_system) && sameValue(edited.after, system)));
    if (system != m_system) {
        if (!goesOn && isUnfinished()) m_drafts.keep(m_system, m_text->toPlainText());
        const auto before = std::exchange(m_system, system);
        if (goesOn)
            followSystem(*before);
        else if (system)
            showSystem();
        showAll();
    }
    tellUnfinished();
}

/// Text that is not in force stays for what the system has become.
void RulesPanel::followSystem(const FuzzySystem& before) {
    const bool wasInForce = m_isInForce;
    m_text->setSystem(*m_system);
    const QString text = m_text->toPlainText(), renamed = withNamesOf(*m_system, before, text);
    if (!wasInForce && renamed != text) m_text->showText(renamed);
    read();
    // What is in force, or is to be, is left as it is written.
    if (wasInForce && !m_isInForce) showText(QString::fromStdString(rulesText(*m_system)));
}

void RulesPanel::showSystem() {
    m_warnings.clear();
    m_refusal.clear();
    m_text->setSystem(*m_system);
    m_text->forgetEdits();
    const std::optional<QString> draft = m_drafts.take(m_system);
    showText(draft ? *draft : QString::fromStdString(rulesText(*m_system)));
}

/// Drafts of another organ are nobody's, though its systems may look the same.
void RulesPanel::leaveOrgan() {
    const Project& project = m_document.project();
    if (project.mesh == m_organ) return;
    m_organ = project.mesh;
    m_drafts.forgetAllBut(project.regions);
    const auto isHere = [&](const Region& region) { return region.system.get() == m_system.get(); };
    if (std::none_of(project.regions.begin(), project.regions.end(), isHere)) m_system = nullptr;
}

void RulesPanel::showText(const QString& text) {
    m_text->showText(text);
    m_isRunning = false;
    read();
}

FuzzySystem RulesPanel::written() const {
    FuzzySystem system = *m_system;
    system.rules = m_reading.rules;
    return system;
}

void RulesPanel::read() {
    m_reading = readRules(*m_system, m_text->lines());
    m_obstacle = QString::fromStdString(m_reading.problem);
    if (m_reading.unread.empty() && m_obstacle.isEmpty()) {
        const std::vector<std::string> problems = validate(written());
        if (!problems.empty()) m_obstacle = QString::fromStdString(problems.front());
    }
    m_isInForce = m_reading.unread.empty() && m_obstacle.isEmpty() && m_reading.rules == m_system->rules;
}

/// Whom the change is for is asked at its first letter, which then goes again where it is for nobody.
void RulesPanel::takeText() {
    if (!m_reach.ask()) return m_text->takeBack();
    m_refusal.clear();
    read();
    apply();
    m_rest->start();
    showAll();
}

void RulesPanel::apply() {
    if (m_isInForce || !m_reading.unread.empty() || !m_obstacle.isEmpty()) return;
    const std::optional<Reach> reach = m_reach.ask();
    if (!reach) return;
    m_isRunning = true;
    editSelectedSystem(m_document, m_selection, written(), {tr("Edit rules"), EditKind::Rules, *reach});
}

void RulesPanel::takeTable(const QStringList& lines) {
    finishRun();
    m_text->editText(lines.join('\n'));
    finishRun();
}

/// What the text can take back is no more than the edit that is being made, or what is not in force: the rest
/// is the document's to undo.
void RulesPanel::finishRun() {
    m_rest->stop();
    if (m_isRunning) m_document.finishGesture();
    m_isRunning = false;
    if (m_isInForce) m_text->forgetUndo();
}

void RulesPanel::undo() {
    if (!m_text->undoText()) return m_document.undoStack()->undo();
    if (m_isInForce && !m_isRunning) m_text->forgetUndo();
}

void RulesPanel::redo() {
    if (!m_text->redoText()) m_document.undoStack()->redo();
}

void RulesPanel::putBack() {
    if (!isUnfinished()) return;
    m_text->editText(QString::fromStdString(rulesText(*m_system)));
    m_text->setFocus();
}

void RulesPanel::showAll() {
    showState();
    showTable();
    if (!m_system || m_system->rules.size() <= mostRulesCheckedAtOnce) return check();
    showNotes();
    m_check->start();
}

void RulesPanel::check() {
    m_check->stop();
    if (m_system) m_warnings = systemWarnings(*m_system);
    m_warned = m_system;
    showNotes();
}

void RulesPanel::showTable() {
    if (m_system && m_views->currentWidget() == m_table) m_table->setRules(*m_system, m_text->lines());
}

QString RulesPanel::stateText() const {
    if (m_isInForce) return tr("In force: %1.").arg(rulesCounted(m_system->rules.size()));
    const QString before = m_system->rules.empty()
                               ? tr("Before there was none.")
                               : tr("The %1 before still hold.").arg(rulesCounted(m_system->rules.size()));
    return tr("Not in force%1 %2").arg(firstMistake(), before);
}

/// What keeps the text from being in force, as far as one sentence goes; all of it stands in the notes.
QString RulesPanel::firstMistake() const {
    if (m_reading.unread.empty()) return m_obstacle.isEmpty() ? tr(".") : tr(": %1").arg(m_obstacle);
    const UnreadRule& rule = m_reading.unread.front();
    const std::size_t more = m_reading.unread.size() - 1;
    const QString message = tr(": rule %1, %2").arg(rule.number).arg(QString::fromStdString(rule.message));
    return more > 0 ? message + tr(" (and %1 more).").arg(rulesCounted(more)) : message + '.';
}

void RulesPanel::tellUnfinished() {
    const bool hasDraft = isUnfinished() || m_drafts.concern(m_document.project().regions);
    m_document.setUnfinished(hasDraft ? tr("Rules are written that are not in force, and are not saved.")
                                      : QString());
}

void RulesPanel::showState() {
    tellUnfinished();
    if (!m_system) return;
    m_text->showMistakes(m_reading.unread);
    m_state->setText(stateText());
    m_state->setToolTip(m_state->text());
    m_state->setProperty("quiet", m_isInForce);
    m_state->setProperty("warning", !m_isInForce);
    m_state->style()->polish(m_state);
    const QString inForce = tr("What is written is in force");
    const bool canApply = m_reading.unread.empty() && m_obstacle.isEmpty();
    enable(m_apply, !m_isInForce && canApply, tr("Put what is written in force"),
           m_isInForce ? inForce : tr("What is written cannot be read as rules"));
    enable(m_putBack, !m_isInForce, tr("Put the rules that are in force back into the text"), inForce);
}

void RulesPanel::showNotes() {
    using Kind = RuleNote::Kind;
    std::vector<RuleNote> notes;
    for (const QString& problem : {m_refusal, m_obstacle})
        if (!problem.isEmpty()) notes.push_back({Kind::Mistake, problem});
    for (std::size_t i = 0; i < std::min(m_reading.unread.size(), mostNotes); ++i) {
        const UnreadRule& rule = m_reading.unread[i];
        notes.push_back({Kind::Mistake,
                         tr("Rule %1, %2").arg(rule.number).arg(QString::fromStdString(rule.message)),
                         static_cast<int>(rule.line), static_cast<int>(rule.mistake.column)});
    }
    const std::vector<std::string> text = m_text->lines();
    std::vector<int> lines; // of the rules
    for (std::size_t line = 0; line < text.size(); ++line)
        if (!isBlank(text[line])) lines.push_back(static_cast<int>(line));
    // Only then the rules that are warned of are those in the lines.
    const bool isOfLines = m_isInForce && m_warned == m_system;
    for (const SystemWarning& warning : m_warnings) {
        const std::size_t rule = warning.rules.empty() || !isOfLines ? lines.size() : warning.rules.front();
        notes.push_back(
            {Kind::Warning, QString::fromStdString(warning.text), rule < lines.size() ? lines[rule] : -1});
    }
    if (notes.empty()) notes.push_back({Kind::Quiet, tr("Nothing odd about these rules.")});
    m_notes->setNotes(notes);
}

void RulesPanel::goTo(int line, int column) {
    if (m_views->currentWidget() == m_text)
        return m_text->goTo(static_cast<std::size_t>(line), static_cast<std::size_t>(column));
    const std::vector<std::string> lines = m_text->lines();
    m_table->goTo(static_cast<std::size_t>(std::count_if(
        lines.begin(), lines.begin() + line, [](const std::string& before) { return !isBlank(before); })));
}

} // namespace esm
