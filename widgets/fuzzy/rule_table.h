#pragma once

#include "widgets/fuzzy/rule_table_model.h"

#include <QTableView>
#include <QToolButton>

namespace esm {

/// Rules as a table in which words are chosen, with buttons that add, remove and move rules.
class RuleTable : public QWidget {
    Q_OBJECT

public:
    explicit RuleTable(QWidget* parent = nullptr);

    /// Shows lines, of which each is a rule or is to become one.
    void setRules(const FuzzySystem& system, const std::vector<std::string>& lines);
    /// Goes to a rule, counted from 0.
    void goTo(std::size_t rule);

    QTableView* view() const { return m_view; }
    RuleTableModel* model() const { return m_model; }

signals:
    /// The rules as the user wants them.
    void edited(const QStringList& lines);
    void undoRequested();
    void redoRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void addRow();
    void removeRow();
    void moveRow(int by);
    void editCell(const QModelIndex& index);
    bool answerKey(const QKeyEvent& key);
    bool answerCellKey(const QKeyEvent& key);
    void showSpans();
    int wordsWidth(int column) const;
    void shareWidth();
    void showButtons();

    RuleTableModel* m_model;
    QTableView* m_view;
    QToolButton *m_add, *m_remove, *m_up, *m_down;
};

} // namespace esm
