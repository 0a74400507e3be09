#include "app/editor/panels/fuzzy/fuzzy_workbench.h"

#include "app/editor/dialogs/shipped_systems.h"
#include "app/editor/dialogs/system_questions.h"
#include "app/editor/edits/selected_system.h"
#include "app/editor/panels/fuzzy/domains_panel.h"
#include "app/editor/panels/fuzzy/rules_panel.h"
#include "app/editor/panels/fuzzy/why_panel.h"
#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"

#include <QApplication>
#include <QPushButton>
#include <QSettings>

namespace esm {

namespace {

QLabel* whatToDo() {
    auto* text = new QLabel(
        QObject::tr("No fuzzy system yet. Choose one in the tab Tissue, or begin a new one there: "
                    "its rules, the terms of its variables, and why it says what it says, are then "
                    "shown and edited here."));
    text->setObjectName(QStringLiteral("noSystem"));
    text->setWordWrap(true);
    text->setProperty("quiet", true);
    text->setAlignment(Qt::AlignTop);
    return text;
}

/// Pages of which one is seen. It alone says how much room it needs: in a QStackedWidget the tallest does.
QVBoxLayout* pagesIn(QWidget& room) {
    auto* pages = new QVBoxLayout(&room);
    pages->setContentsMargins(0, 0, 0, 0);
    return pages;
}

/// A field that is hidden while it has the keys would hand them to whatever follows.
void hide(QWidget& page) {
    QWidget* focus = page.window()->focusWidget();
    if (focus && page.isAncestorOf(focus)) focus->clearFocus();
    page.hide();
}

void bringToFront(QLayout& pages, int index) {
    for (int i = 0; i < pages.count(); ++i)
        if (i != index) hide(*pages.itemAt(i)->widget());
    if (index >= 0) pages.itemAt(index)->widget()->show();
}

constexpr QSize smallestWindow(720, 440), usualWindow(900, 620);
const QString geometryKey = QStringLiteral("fuzzyWindow");

} // namespace

FuzzyWorkbench::FuzzyWorkbench(Document& document, Selection& selection, SystemReach& reach, QWidget* parent)
    : Section({}, parent), m_document(document), m_selection(selection), m_content(new QWidget(this)),
      m_pages(pagesIn(*m_content)), m_tabs(new QTabBar), m_elsewhere(new QWidget(this)) {
    QSizePolicy takesWhatIsLeft(QSizePolicy::Preferred, QSizePolicy::Preferred);
    takesWhatIsLeft.setVerticalStretch(1);
    setSizePolicy(takesWhatIsLeft);
    m_tabs->setObjectName(QStringLiteral("workbenchTabs"));
    m_tabs->setAccessibleName(tr("Views of the fuzzy system"));
    m_tabs->setDrawBase(false);
    m_tabs->setExpanding(false);
    guardFromWheel(*m_tabs, Turning::Never);
    m_tabs->setFocusPolicy(Qt::TabFocus);
    connect(m_tabs, &QTabBar::currentChanged, this, &FuzzyWorkbench::showTab);
    auto* tabbed = new QWidget;
    auto* column = new QVBoxLayout(tabbed);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_tabs, 0, Qt::AlignLeft);
    auto* panels = new QWidget;
    m_panels = pagesIn(*panels);
    column->addWidget(panels, 1);
    m_pages->addWidget(whatToDo());
    m_pages->addWidget(tabbed);
    body()->addWidget(m_content);
    body()->addWidget(m_elsewhere, 0, Qt::AlignTop);
    m_elsewhere->hide();

    addTab(tr("Rules"), tr("What follows from what, as text or as a table"),
           new RulesPanel(document, selection, reach));
    addTab(tr("Domains"), tr("Ranges of inputs and outputs, and the terms over them"),
           new DomainsPanel(document, selection, reach));
    addTab(tr("Why"), tr("How the tissue comes about: which rules fire, and what another input would change"),
           new WhyPanel(document, selection));

    reach.setQuestion([this](const FuzzySystem& system, const std::vector<const Region*>& users) {
        const QString selected = QString::fromStdString(m_selection.selectedRegion()->name);
        return askReach(*m_content->window(), system, selected, users);
    });
    connect(&selection, &Selection::changed, this, &FuzzyWorkbench::showSystem);
    connect(&document, &Document::changed, this, [this](const Change& change) {
        if (change.regions || change.mesh) showSystem();
    });
    showSystem();
}

void FuzzyWorkbench::addTab(const QString& name, const QString& toolTip, QWidget* panel) {
    m_panels->addWidget(panel);
    m_tabs->setTabToolTip(m_tabs->addTab(name), toolTip);
    showTab(m_tabs->currentIndex());
}

void FuzzyWorkbench::showTab(int index) {
    bringToFront(*m_panels, index);
}

void FuzzyWorkbench::setWindowAction(QAction* action) {
    m_windowAction = action;
    QToolButton* enlarge = addHeaderIcon(icon(QStringLiteral("enlarge")), action->toolTip());
    enlarge->setObjectName(QStringLiteral("headerButton"));
    auto* back = new QPushButton(tr("Bring it back here"), m_elsewhere);
    auto* row = new QHBoxLayout(m_elsewhere);
    row->setContentsMargins(0, 0, 0, 0);
    auto* where = new QLabel(tr("In a window of its own"), m_elsewhere);
    where->setProperty("quiet", true);
    row->addWidget(where, 1);
    row->addWidget(back);
    follow(enlarge, action);
    connect(back, &QPushButton::clicked, action, &QAction::trigger);
    connect(action, &QAction::toggled, this, [this, enlarge](bool inWindow) {
        enlarge->setVisible(!inWindow);
        if (inWindow)
            moveToWindow();
        else
            moveToColumn();
    });
}

void FuzzyWorkbench::showSystem() {
    bringToFront(*m_pages, selectedSystem(m_selection) ? 1 : 0);
    showName();
}

void FuzzyWorkbench::showName() {
    const auto system = selectedSystem(m_selection);
    const Region* region = m_selection.selectedRegion();
    // Whether it is the shipped one takes a moment to tell, and sliders move often.
    if (!m_named || system != m_named)
        m_name = system ? tr("Fuzzy system · %1").arg(shownName(*system)) : tr("Fuzzy system");
    m_named = system;
    setTitle(m_name);
    if (!m_window) return;
    const QString where = region ? QString::fromStdString(region->name) : tr("Whole organ");
    m_window->setWindowTitle(QStringLiteral("%1 – %2").arg(m_name, where));
}

void FuzzyWorkbench::moveToWindow() {
    if (!m_window) {
        // As a tool of the main window it leaves that one's keys in force, and stays above it.
        m_window = new QWidget(window(), Qt::Tool);
        m_window->setObjectName(QStringLiteral("workbenchWindow"));
        m_window->setAttribute(Qt::WA_StyledBackground);
        m_window->setMinimumSize(smallestWindow);
        m_window->resize(usualWindow);
        m_window->restoreGeometry(QSettings().value(geometryKey).toByteArray());
        m_window->installEventFilter(this);
        keepControlKeys(*m_window);
        (new QVBoxLayout(m_window))->setContentsMargins(14, 12, 14, 14);
    }
    showName();
    m_elsewhere->show();
    m_window->layout()->addWidget(m_content);
    m_content->show();
    m_window->show();
    m_window->activateWindow();
}

void FuzzyWorkbench::moveToColumn() {
    if (!m_window || m_content->parentWidget() != m_window) return;
    QSettings().setValue(geometryKey, m_window->saveGeometry());
    // What is being typed counts, as where any field is left.
    if (QWidget* focus = m_window->focusWidget()) focus->clearFocus();
    m_elsewhere->hide();
    body()->insertWidget(0, m_content);
    m_content->show();
    m_window->hide();
}

bool FuzzyWorkbench::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_window && event->type() == QEvent::Close) m_windowAction->setChecked(false);
    return Section::eventFilter(watched, event);
}

} // namespace esm
