#pragma once

#include "core/fuzzy/rule_row.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <vector>

namespace esm {

/// Rules as a table: a row per rule, a column per input and per output, and the weight. Holds the lines it
/// was given; an edit is announced, and shown once the lines say so.
class RuleTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    /// What a cell holds: choices of words, a text over several columns, or the weight.
    enum class CellKind { Choice, Text, Weight };

    using QAbstractTableModel::QAbstractTableModel;

    /// Lines without a word are no rows.
    void setRules(const FuzzySystem& system, const std::vector<std::string>& lines);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    CellKind kindOf(const QModelIndex& index) const;
    /// Of a text cell, how many columns it takes, itself counted; 1 of any other.
    int spanOf(const QModelIndex& index) const;
    /// What may be chosen in a cell; the first stands for no choice.
    QStringList choicesOf(const QModelIndex& index) const;

    /// The lines with a row added behind another (−1: before all), removed, or moved.
    QStringList withRowAdded(int behind) const;
    QStringList withRowRemoved(int row) const;
    QStringList withRowMoved(int row, int to) const;

signals:
    /// The rules as the user wants them.
    void edited(const QStringList& lines);

private:
    const RuleRow& row(const QModelIndex& index) const { return m_rows[std::size_t(index.row())]; }
    bool isInput(int column) const { return column < static_cast<int>(m_system.inputs.size()); }
    bool isWeight(int column) const { return column == columnCount() - 1; }
    std::size_t outputOf(int column) const { return std::size_t(column) - m_system.inputs.size(); }
    const FuzzyVariable& variableOf(int column) const;
    int choiceOf(const QModelIndex& index) const;
    void choose(RuleRow& row, int column, int choice) const;
    QString textOf(const QModelIndex& index) const;
    QString explanationOf(const QModelIndex& index) const;
    QString spokenChoice(const QModelIndex& index) const;
    QStringList allLines() const;

    FuzzySystem m_system; ///< its variables
    std::vector<RuleRow> m_rows;
    std::vector<std::string> m_lines; ///< one per row
};

} // namespace esm
