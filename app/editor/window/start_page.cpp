#include "app/editor/window/start_page.h"

#include "app/editor/document/file_memory.h"
#include "app/editor/window/actions.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>

namespace esm {

namespace {

constexpr int columnWidth = 340; // pixels, at most
constexpr int mostRecent = 8;

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setObjectName(QStringLiteral("sectionTitle"));
    return label;
}

/// A line that says what it does, and under it what that means.
QPushButton* entry(const QString& text, const QString& explanation) {
    auto* button = new QPushButton;
    button->setObjectName(QStringLiteral("startEntry"));
    auto* lines = new QVBoxLayout(button);
    lines->setContentsMargins(12, 8, 12, 8);
    lines->setSpacing(2);
    auto* title = new QLabel(text);
    title->setProperty("strong", true);
    auto* under = new QLabel(explanation);
    under->setProperty("quiet", true);
    under->setWordWrap(true);
    for (QLabel* line : {title, under}) {
        line->setAttribute(Qt::WA_TransparentForMouseEvents);
        lines->addWidget(line);
    }
    button->setAccessibleName(text);
    button->setAccessibleDescription(explanation);
    button->setToolTip(explanation);
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    button->setMinimumHeight(lines->totalHeightForWidth(columnWidth));
    return button;
}

QPushButton* entry(QAction* action) {
    const QString text = withoutMnemonic(action->text());
    QPushButton* button = entry(text, whatItDoes(action));
    const auto follow = [button, action] { button->setToolTip(action->toolTip()); };
    QObject::connect(action, &QAction::changed, button, follow);
    follow();
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    return button;
}

QVBoxLayout* columnIn(QWidget* widget) {
    widget->setMaximumWidth(columnWidth);
    widget->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    return column;
}

} // namespace

StartPage::StartPage(const Actions& actions, QWidget* parent) : QScrollArea(parent) {
    setObjectName(QStringLiteral("startPage"));
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setFocusPolicy(Qt::NoFocus); // it follows the entry that has the keys
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("startBody"));
    auto* title = new QLabel(tr("Elastodynamic Shape Modeler"));
    title->setObjectName(QStringLiteral("startTitle"));
    auto* subtitle = new QLabel(tr("Deformable organs for surgical simulators"));
    subtitle->setProperty("quiet", true);
    auto* recent = new QWidget;
    m_recent = columnIn(recent);

    auto* columns = new QHBoxLayout;
    columns->setSpacing(40);
    columns->addStretch();
    columns->addWidget(waysToBegin(actions), 1, Qt::AlignTop);
    columns->addWidget(recent, 1, Qt::AlignTop);
    columns->addStretch();
    auto* page = new QVBoxLayout(body);
    page->addStretch(1);
    page->addWidget(title, 0, Qt::AlignHCenter);
    page->addWidget(subtitle, 0, Qt::AlignHCenter);
    page->addSpacing(24);
    page->addLayout(columns);
    page->addStretch(2);
    setWidget(body);
}

QWidget* StartPage::waysToBegin(const Actions& actions) {
    auto* widget = new QWidget;
    QVBoxLayout* column = columnIn(widget);
    column->addWidget(heading(tr("Begin")));
    QPushButton* steps = entry(
        tr("First steps"), tr("Five hints on a liver: pull, add a region, set its tissue, compare, export"));
    steps->setProperty("firstSteps", true);
    connect(steps, &QPushButton::clicked, this, &StartPage::firstStepsAsked);
    column->addWidget(steps);
    column->addWidget(entry(actions.import));
    column->addWidget(entry(actions.open));
    column->addSpacing(8);
    column->addWidget(heading(tr("Samples")));
    auto* samples = new QHBoxLayout;
    for (const auto& sample : actions.samples) {
        auto* button = new QPushButton(plainText(sample.second));
        button->setToolTip(sample.second->toolTip());
        connect(button, &QPushButton::clicked, sample.second, &QAction::trigger);
        samples->addWidget(button);
    }
    samples->addStretch();
    column->addLayout(samples);
    return widget;
}

void StartPage::showEvent(QShowEvent* event) {
    QScrollArea::showEvent(event);
    fillRecent();
}

void StartPage::fillRecent() {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_recent->addWidget(heading(tr("Opened last")));
    const QStringList files = recentFiles().mid(0, mostRecent);
    for (const QString& file : files) {
        const QFileInfo info(file);
        QPushButton* button = entry(info.fileName(), QDir::toNativeSeparators(info.path()));
        button->setToolTip(QDir::toNativeSeparators(file));
        connect(button, &QPushButton::clicked, this, [this, file] { emit recentChosen(file); });
        m_recent->addWidget(button);
    }
    if (!files.isEmpty()) return;
    auto* none = new QLabel(tr("No file was opened yet. One can also be dropped onto this window."));
    none->setProperty("quiet", true);
    none->setWordWrap(true);
    m_recent->addWidget(none);
}

} // namespace esm
