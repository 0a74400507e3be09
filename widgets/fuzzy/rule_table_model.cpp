#include "widgets/fuzzy/rule_table_model.h"

#include "core/fuzzy/rule_lines.h"
#include "widgets/fuzzy/term_scale.h"
#include "widgets/inputs/number_text.h"

#include <QGuiApplication>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <iterator>

namespace esm {

namespace {

const QString notAsked(QChar(0x2013)); // a dash

QColor paletteColour(QPalette::ColorRole role) {
    return QGuiApplication::palette().color(role);
}

} // namespace

void RuleTableModel::setRules(const FuzzySystem& system, const std::vector<std::string>& lines) {
    std::vector<std::string> words;
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(words),
                 [](const std::string& line) { return !isBlank(line); });
    const bool isSameShape = words.size() == m_lines.size() &&
                             system.inputs.size() == m_system.inputs.size() &&
                             system.outputs.size() == m_system.outputs.size();
    if (!isSameShape) beginResetModel();
    m_system = system;
    m_system.rules.clear();
    m_lines = std::move(words);
    m_rows.clear();
    for (const std::string& line : m_lines)
        m_rows.push_back(rowOf(m_system, line));
    if (!isSameShape) return endResetModel();
    // What is selected stays so.
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int RuleTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RuleTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_system.inputs.size() + m_system.outputs.size()) + 1;
}

const FuzzyVariable& RuleTableModel::variableOf(int column) const {
    return isInput(column) ? m_system.inputs[std::size_t(column)] : m_system.outputs[outputOf(column)];
}

RuleTableModel::CellKind RuleTableModel::kindOf(const QModelIndex& index) const {
    const RuleRow& shown = row(index);
    if (!shown.unread.empty()) return CellKind::Text;
    if (isWeight(index.column())) return CellKind::Weight;
    const bool isText = isInput(index.column()) ? !shown.condition.empty() : !shown.conclusions.empty();
    return isText ? CellKind::Text : CellKind::Choice;
}

int RuleTableModel::spanOf(const QModelIndex& index) const {
    if (kindOf(index) != CellKind::Text) return 1;
    const auto inputs = static_cast<int>(m_system.inputs.size());
    if (!row(index).unread.empty()) return index.column() == 0 ? columnCount() : 1;
    if (index.column() == 0) return inputs;
    return index.column() == inputs ? static_cast<int>(m_system.outputs.size()) : 1;
}

/// The terms in order and, of inputs, each denied.
QStringList RuleTableModel::choicesOf(const QModelIndex& index) const {
    QStringList choices{notAsked};
    const FuzzyVariable& variable = variableOf(index.column());
    for (const FuzzyTerm& term : variable.terms)
        choices << readableName(term.name);
    if (isInput(index.column()))
        for (const FuzzyTerm& term : variable.terms)
            choices << tr("not %1").arg(readableName(term.name));
    return choices;
}

int RuleTableModel::choiceOf(const QModelIndex& index) const {
    const RuleRow& shown = row(index);
    if (!isInput(index.column())) {
        const auto& term = shown.outputs[outputOf(index.column())];
        return term ? static_cast<int>(*term) + 1 : 0;
    }
    const auto& choice = shown.inputs[std::size_t(index.column())];
    if (!choice) return 0;
    const std::size_t terms = variableOf(index.column()).terms.size();
    return static_cast<int>(choice->term + (choice->isNegated ? terms : 0)) + 1;
}

void RuleTableModel::choose(RuleRow& row, int column, int choice) const {
    const auto term = static_cast<std::size_t>(choice - 1), terms = variableOf(column).terms.size();
    if (!isInput(column))
        row.outputs[outputOf(column)] = choice > 0 ? std::optional(term) : std::nullopt;
    else if (choice > 0)
        row.inputs[std::size_t(column)] = RuleRow::Choice{term % terms, term >= terms};
    else
        row.inputs[std::size_t(column)].reset();
}

QString RuleTableModel::textOf(const QModelIndex& index) const {
    const RuleRow& shown = row(index);
    if (!shown.unread.empty()) return QString::fromStdString(shown.unread);
    if (isWeight(index.column())) return numberText(shown.weight, 3).remove(QRegularExpression("\\.?0+$"));
    return QString::fromStdString(isInput(index.column()) ? shown.condition : shown.conclusions);
}

QString RuleTableModel::explanationOf(const QModelIndex& index) const {
    if (!row(index).unread.empty()) return tr("This is no rule yet: %1").arg(textOf(index));
    if (kindOf(index) == CellKind::Text)
        return tr("%1\nA text, since it says more than a choice of words can.").arg(textOf(index));
    if (isWeight(index.column())) return tr("Weight of the rule, 0 to 1");
    return isInput(index.column()) ? tr("What the rule asks of %1; a dash asks nothing")
                                         .arg(readableName(variableOf(index.column()).name))
                                   : tr("What the rule says of %1; a dash says nothing")
                                         .arg(readableName(variableOf(index.column()).name));
}

QString RuleTableModel::spokenChoice(const QModelIndex& index) const {
    return tr("%1: %2").arg(readableName(variableOf(index.column()).name), choicesOf(index)[choiceOf(index)]);
}

QVariant RuleTableModel::data(const QModelIndex& index, int role) const {
    const CellKind kind = kindOf(index);
    const bool isChoice = kind == CellKind::Choice;
    switch (role) {
    case Qt::DisplayRole:
        return isChoice ? choicesOf(index)[choiceOf(index)] : textOf(index);
    case Qt::EditRole:
        if (isChoice) return choiceOf(index);
        return kind == CellKind::Weight ? QVariant(row(index).weight) : textOf(index);
    case Qt::ToolTipRole:
        return isChoice ? spokenChoice(index) + '\n' + explanationOf(index) : explanationOf(index);
    case Qt::ForegroundRole:
        if (!row(index).unread.empty()) return paletteColour(QPalette::BrightText);
        if (isChoice && choiceOf(index) == 0) return paletteColour(QPalette::PlaceholderText);
        if (kind == CellKind::Weight && row(index).weight == 1)
            return paletteColour(QPalette::PlaceholderText);
        return {};
    case Qt::AccessibleTextRole:
        return isChoice ? spokenChoice(index) : textOf(index);
    default:
        return {};
    }
}

QVariant RuleTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    if (section < 0 || section >= columnCount()) return {};
    const QString name = isWeight(section) ? tr("weight") : readableName(variableOf(section).name);
    if (role == Qt::DisplayRole)
        return isInput(section) || isWeight(section) ? name : QChar(0x2192) + QStringLiteral(" ") + name;
    if (role != Qt::ToolTipRole) return {};
    if (isWeight(section)) return tr("How much a rule counts, 0 to 1");
    return isInput(section) ? tr("%1, what rules ask for").arg(name) : tr("%1, what rules say").arg(name);
}

Qt::ItemFlags RuleTableModel::flags(const QModelIndex&) const {
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable;
}

QStringList RuleTableModel::allLines() const {
    QStringList lines;
    for (const std::string& line : m_lines)
        lines << QString::fromStdString(line);
    return lines;
}

bool RuleTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || value == data(index, Qt::EditRole)) return false;
    RuleRow changed = row(index);
    const std::string text = value.toString().simplified().toStdString();
    switch (kindOf(index)) {
    case CellKind::Choice:
        choose(changed, index.column(), value.toInt());
        break;
    case CellKind::Weight:
        changed.weight = value.toDouble();
        break;
    case CellKind::Text:
        (!changed.unread.empty()   ? changed.unread
         : isInput(index.column()) ? changed.condition
                                   : changed.conclusions) = text;
        break;
    }
    QStringList lines = allLines();
    lines[index.row()] = QString::fromStdString(lineOf(m_system, changed));
    emit edited(lines);
    return true;
}

QStringList RuleTableModel::withRowAdded(int behind) const {
    QStringList lines = allLines();
    lines.insert(behind + 1, QStringLiteral("IF THEN"));
    return lines;
}

QStringList RuleTableModel::withRowRemoved(int row) const {
    QStringList lines = allLines();
    lines.removeAt(row);
    return lines;
}

QStringList RuleTableModel::withRowMoved(int row, int to) const {
    QStringList lines = allLines();
    lines.move(row, to);
    return lines;
}

} // namespace esm
