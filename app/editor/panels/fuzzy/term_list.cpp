#include "app/editor/panels/fuzzy/term_list.h"

#include "widgets/fuzzy/partition_picture.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"

#include <QVBoxLayout>

namespace esm {

namespace {

constexpr int shortHeight = 5 * 27; // pixels, of five rows

QToolButton* termButton(QWidget* parent, const QString& name) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QStringLiteral("headerButton"));
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(name);
    button->setToolTip(name);
    return button;
}

QToolButton* termIcon(QWidget* parent, const QString& iconName, const QString& name) {
    QToolButton* button = termButton(parent, name);
    button->setIcon(icon(iconName));
    button->setIconSize({16, 16});
    button->setProperty("iconOnly", true);
    return button;
}

} // namespace

TermList::TermList(QWidget* parent)
    : QWidget(parent), m_list(new ItemList(QPalette::Link, this)), m_message(new QLabel(this)) {
    m_list->setObjectName(QStringLiteral("termList"));
    m_list->setAccessibleName(tr("Terms"));
    m_list->setToolTip(
        tr("F2 or a double click renames, Del removes, Ctrl with Up or Down changes the order"));
    m_list->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    m_list->setMinimumHeight(shortHeight);
    m_message->setObjectName(QStringLiteral("domainMessage"));
    m_message->setProperty("warning", true);
    m_message->setWordWrap(true);
    m_message->setAlignment(Qt::AlignTop);
    m_message->setFixedHeight(2 * m_message->fontMetrics().lineSpacing() + 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addLayout(header());
    column->addWidget(m_list, 1);
    column->addLayout(helpers());
    column->addWidget(m_message);
    connect(m_list, &ItemList::rowSelected, this, [this](int row) {
        if (row >= 0) emit termTaken(static_cast<std::size_t>(row));
    });
    connect(m_list, &ItemList::rowRenamed, this, [this](int row, const QString& typed) {
        emit termRenamed(static_cast<std::size_t>(row), typed);
    });
    connect(m_list, &ItemList::removeRequested, this, &TermList::removeRequested);
    connect(m_list, &ItemList::moveRequested, this,
            [this](int row, int to) { emit moveRequested(to - row); });
}

QLayout* TermList::header() {
    auto* title = new QLabel(tr("Terms"), this);
    title->setObjectName(QStringLiteral("sectionTitle"));
    m_up = termIcon(this, QStringLiteral("up"), tr("Move the term up"));
    m_down = termIcon(this, QStringLiteral("down"), tr("Move the term down"));
    m_remove = termIcon(this, QStringLiteral("remove"), tr("Remove the term (Del)"));
    QToolButton* add = termButton(this, tr("Add a term where there is most room"));
    add->setText(tr("+ add"));
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(title, 1);
    for (QToolButton* button : {m_up, m_down, m_remove, add})
        row->addWidget(button);
    connect(m_up, &QToolButton::clicked, this, [this] { emit moveRequested(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { emit moveRequested(1); });
    connect(m_remove, &QToolButton::clicked, this, &TermList::removeRequested);
    connect(add, &QToolButton::clicked, this, &TermList::addRequested);
    return row;
}

QLayout* TermList::helpers() {
    auto* even = new QPushButton(tr("Even partition"), this);
    even->setToolTip(tr("Spread the terms evenly over the range, in this order"));
    auto* overlap = new QPushButton(tr("Overlap by half"), this);
    overlap->setToolTip(
        tr("Draw each term's end over the beginning of the next one, so that degrees add up to 1"));
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    for (QPushButton* helper : {even, overlap}) {
        helper->setFocusPolicy(Qt::TabFocus);
        row->addWidget(helper, 1);
    }
    connect(even, &QPushButton::clicked, this, &TermList::evenRequested);
    connect(overlap, &QPushButton::clicked, this, &TermList::overlapRequested);
    return row;
}

void TermList::setTerms(const FuzzyVariable& variable, std::size_t inHand, std::optional<double> value) {
    std::vector<ItemRow> rows;
    for (std::size_t i = 0; i < variable.terms.size(); ++i) {
        const FuzzyTerm& term = variable.terms[i];
        const double degree = value ? membership(term.set, *value) : 0;
        const QString note = degree > 0 ? QString::number(degree, 'f', 2) : QString();
        const QColor colour =
            i == inHand ? palette().color(QPalette::Link) : termColour(i, variable.terms.size(), palette());
        rows.push_back({readableName(term.name), note, colour, {}, true});
    }
    m_list->setRows(rows, static_cast<int>(inHand));
    const std::size_t last = variable.terms.size() - 1;
    enable(m_up, inHand > 0, tr("Move the term up (Ctrl+Up)"), tr("It is the first already"));
    enable(m_down, inHand < last, tr("Move the term down (Ctrl+Down)"), tr("It is the last already"));
    enable(m_remove, last > 0, tr("Remove the term (Del)"), tr("A variable has at least one term"));
}

void TermList::setProblems(const std::vector<std::string>& problems) {
    QStringList lines;
    for (const std::string& problem : problems)
        lines << readableName(problem);
    m_message->setToolTip(lines.join('\n'));
    const QString more = lines.size() > 1 ? tr(" (and %1 more)").arg(lines.size() - 1) : QString();
    m_message->setText(lines.isEmpty() ? QString() : lines.front() + more);
}

void TermList::setTall(bool tall) {
    m_list->setMaximumHeight(tall ? QWIDGETSIZE_MAX : shortHeight);
}

void TermList::askName(std::size_t term) {
    m_list->setFocus();
    m_list->editItem(m_list->item(static_cast<int>(term)));
}

} // namespace esm
