#include "widgets/fuzzy/rule_table.h"

#include "widgets/inputs/control_keys.h"
#include "widgets/inputs/enabling.h"
#include "widgets/inputs/icon.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyledItemDelegate>
#include <QTimer>

#include <algorithm>
#include <numeric>

namespace esm {

namespace {

constexpr int widestColumn = 220, narrowestColumn = 56, cellPadding = 14; // pixels

/// A cell is edited as what it is: words are chosen, texts typed.
class RuleCellDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        const auto& model = static_cast<const RuleTableModel&>(*index.model());
        switch (model.kindOf(index)) {
        case RuleTableModel::CellKind::Choice:
            return choiceEditor(parent, model.choicesOf(index));
        case RuleTableModel::CellKind::Weight:
            return weightEditor(parent);
        default:
            return QStyledItemDelegate::createEditor(parent, option, index);
        }
    }

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* choice = qobject_cast<QComboBox*>(editor))
            choice->setCurrentIndex(index.data(Qt::EditRole).toInt());
        else
            QStyledItemDelegate::setEditorData(editor, index);
    }

    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (const auto* choice = qobject_cast<const QComboBox*>(editor))
            model->setData(index, choice->currentIndex());
        else
            QStyledItemDelegate::setModelData(editor, model, index);
    }

private:
    QWidget* choiceEditor(QWidget* parent, const QStringList& words) const {
        auto* choice = new QComboBox(parent);
        choice->addItems(words);
        auto* self = const_cast<RuleCellDelegate*>(this);
        connect(choice, qOverload<int>(&QComboBox::activated), self, [self, choice] {
            emit self->commitData(choice);
            emit self->closeEditor(choice);
        });
        QTimer::singleShot(0, choice, &QComboBox::showPopup);
        return choice;
    }

    static QWidget* weightEditor(QWidget* parent) {
        auto* weight = new QDoubleSpinBox(parent);
        weight->setRange(0, 1);
        weight->setSingleStep(0.1);
        weight->setDecimals(3);
        weight->setButtonSymbols(QAbstractSpinBox::NoButtons);
        weight->setLocale(QLocale::c());
        return weight;
    }
};

QToolButton* quietButton(QWidget* parent, const QString& iconName) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QStringLiteral("quietButton"));
    button->setIcon(icon(iconName));
    return button;
}

} // namespace

RuleTable::RuleTable(QWidget* parent)
    : QWidget(parent), m_model(new RuleTableModel(this)), m_view(new QTableView(this)),
      m_add(new QToolButton(this)), m_remove(quietButton(this, QStringLiteral("remove"))),
      m_up(quietButton(this, QStringLiteral("up"))), m_down(quietButton(this, QStringLiteral("down"))) {
    m_view->setObjectName(QStringLiteral("ruleTableView"));
    m_view->setAccessibleName(tr("Rules as a table"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new RuleCellDelegate(m_view));
    m_view->setTabKeyNavigation(false);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_view->setHorizontalScrollMode(QAbstractItemView::ScrollPerItem);
    m_view->setWordWrap(false);
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->horizontalHeader()->setTextElideMode(Qt::ElideRight);
    m_view->verticalHeader()->setHighlightSections(false);
    m_view->installEventFilter(this);
    m_add->setObjectName(QStringLiteral("quietButton"));
    m_add->setText(tr("Add rule"));
    m_add->setToolTip(tr("Add a rule behind the one that is selected"));
    m_up->setAccessibleName(tr("Move the rule up"));
    m_down->setAccessibleName(tr("Move the rule down"));
    m_remove->setAccessibleName(tr("Remove the rule"));

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(6);
    buttons->addWidget(m_add);
    buttons->addStretch();
    for (QToolButton* button : {m_up, m_down, m_remove})
        buttons->addWidget(button);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_view, 1);
    column->addLayout(buttons);

    connect(m_model, &RuleTableModel::edited, this, &RuleTable::edited);
    connect(m_view, &QTableView::clicked, this, &RuleTable::editCell);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &RuleTable::showButtons);
    connect(m_add, &QToolButton::clicked, this, &RuleTable::addRow);
    connect(m_remove, &QToolButton::clicked, this, &RuleTable::removeRow);
    connect(m_up, &QToolButton::clicked, this, [this] { moveRow(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { moveRow(1); });
    showButtons();
}

void RuleTable::setRules(const FuzzySystem& system, const std::vector<std::string>& lines) {
    const QModelIndex before = m_view->currentIndex();
    const int row = before.row(), column = before.column();
    m_model->setRules(system, lines);
    showSpans();
    shareWidth();
    if (before.isValid() && m_model->rowCount() > 0)
        m_view->setCurrentIndex(m_model->index(std::min(row, m_model->rowCount() - 1),
                                               std::min(column, m_model->columnCount() - 1)));
    showButtons();
}

void RuleTable::goTo(std::size_t rule) {
    const int row = static_cast<int>(rule);
    m_view->setCurrentIndex(m_model->index(row, std::max(0, m_view->currentIndex().column())));
    m_view->setFocus();
}

void RuleTable::showSpans() {
    m_view->clearSpans();
    for (int row = 0; row < m_model->rowCount(); ++row)
        for (int column = 0; column < m_model->columnCount();) {
            const int span = m_model->spanOf(m_model->index(row, column));
            if (span > 1) m_view->setSpan(row, column, 1, span);
            column += span;
        }
}

/// What the words of a column need.
int RuleTable::wordsWidth(int column) const {
    int width = narrowestColumn;
    for (int row = 0; row < m_model->rowCount(); ++row) {
        const QModelIndex cell = m_model->index(row, column);
        if (m_model->kindOf(cell) == RuleTableModel::CellKind::Text) continue;
        const QString text = cell.data().toString();
        width = std::max(width, m_view->fontMetrics().horizontalAdvance(text) + cellPadding);
    }
    return std::min(width, widestColumn);
}

/// Each column as wide as its words and its head, wider where there is room. Where there is too little, heads
/// are cut, from the last on, and say all in tool tips.
void RuleTable::shareWidth() {
    const int columns = m_model->columnCount(), room = m_view->viewport()->width();
    std::vector<int> least, widths;
    least.reserve(std::size_t(columns));
    widths.reserve(std::size_t(columns));
    for (int column = 0; column < columns; ++column) {
        least.push_back(wordsWidth(column));
        const int head = std::min(m_view->horizontalHeader()->sectionSizeHint(column), widestColumn);
        widths.push_back(std::max(least.back(), head));
    }
    int spare = room - std::accumulate(widths.begin(), widths.end(), 0);
    for (std::size_t column = widths.size(); column-- > 0 && spare < 0;) {
        const int given = std::min(-spare, widths[column] - least[column]);
        widths[column] -= given;
        spare += given;
    }
    spare = std::max(spare, 0);
    for (int column = 0; column < columns; ++column)
        m_view->setColumnWidth(column, widths[std::size_t(column)] + spare / columns +
                                           (column < spare % columns ? 1 : 0));
}

void RuleTable::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    QTimer::singleShot(0, this, &RuleTable::shareWidth);
}

void RuleTable::editCell(const QModelIndex& index) {
    if (m_model->kindOf(index) == RuleTableModel::CellKind::Choice) m_view->edit(index);
}

void RuleTable::addRow() {
    const QModelIndex current = m_view->currentIndex();
    const int behind = current.isValid() ? current.row() : m_model->rowCount() - 1;
    emit edited(m_model->withRowAdded(behind));
    m_view->setCurrentIndex(m_model->index(behind + 1, 0));
    m_view->setFocus();
}

void RuleTable::removeRow() {
    if (m_view->currentIndex().isValid()) emit edited(m_model->withRowRemoved(m_view->currentIndex().row()));
}

void RuleTable::moveRow(int by) {
    const QModelIndex current = m_view->currentIndex();
    const int to = current.row() + by, column = current.column();
    if (!current.isValid() || to < 0 || to >= m_model->rowCount()) return;
    emit edited(m_model->withRowMoved(current.row(), to));
    m_view->setCurrentIndex(m_model->index(to, column));
}

void RuleTable::showButtons() {
    const QModelIndex current = m_view->currentIndex();
    const QString none = tr("No rule is selected");
    enable(m_remove, current.isValid(), tr("Remove the rule (Ctrl+Del)"), none);
    enable(m_up, current.row() > 0, tr("Move the rule up (Alt+Up)"),
           current.isValid() ? tr("This rule is the first") : none);
    enable(m_down, current.isValid() && current.row() + 1 < m_model->rowCount(),
           tr("Move the rule down (Alt+Down)"), current.isValid() ? tr("This rule is the last") : none);
}

bool RuleTable::answerKey(const QKeyEvent& key) {
    if (key.matches(QKeySequence::Undo)) {
        emit undoRequested();
        return true;
    }
    if (isRedo(key)) {
        emit redoRequested();
        return true;
    }
    // Keys of a cell's editor come by as well.
    return m_view->currentIndex().isValid() && m_view->hasFocus() && answerCellKey(key);
}

bool RuleTable::answerCellKey(const QKeyEvent& key) {
    const QModelIndex current = m_view->currentIndex();
    const bool isPlain = key.modifiers() == Qt::NoModifier;
    if (key.key() == Qt::Key_Delete && key.modifiers() == Qt::ControlModifier)
        removeRow();
    else if (key.key() == Qt::Key_Up && key.modifiers() == Qt::AltModifier)
        moveRow(-1);
    else if (key.key() == Qt::Key_Down && key.modifiers() == Qt::AltModifier)
        moveRow(1);
    else if (isPlain &&
             (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter || key.key() == Qt::Key_Space))
        m_view->edit(current);
    else if (isPlain && key.key() == Qt::Key_Delete &&
             m_model->kindOf(current) == RuleTableModel::CellKind::Choice)
        m_model->setData(current, 0, Qt::EditRole);
    else
        return false;
    return true;
}

bool RuleTable::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        // Keys of the window that the table answers itself.
        const bool isOwn = key->matches(QKeySequence::Undo) || isRedo(*key) || key->key() == Qt::Key_Space;
        if (isOwn) event->accept();
        return isOwn;
    }
    if (event->type() == QEvent::KeyPress && answerKey(*static_cast<QKeyEvent*>(event))) return true;
    return QWidget::eventFilter(watched, event);
}

} // namespace esm
