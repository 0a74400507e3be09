#pragma once

#include "core/fuzzy/fuzzy_system.h"
#include "widgets/inputs/item_list.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <optional>

namespace esm {

/// The terms of a variable in their order, one of them in hand, with what can be done to them.
class TermList : public QWidget {
    Q_OBJECT

public:
    explicit TermList(QWidget* parent = nullptr);

    /// Shows a variable's terms with the degrees of its present value, announcing nothing.
    void setTerms(const FuzzyVariable& variable, std::size_t inHand, std::optional<double> value);
    /// Why something could not be done; there is room for one reason, so that nothing moves, and all are in
    /// the tool tip.
    void setProblems(const std::vector<std::string>& problems);
    /// As high as the list is given room for, else of one height for every variable.
    void setTall(bool tall);
    /// Lets the user type the name of a term.
    void askName(std::size_t term);

signals:
    void termTaken(std::size_t term);
    void termRenamed(std::size_t term, const QString& typed);
    void addRequested();
    void removeRequested();
    /// So many places down, or up where it is below zero.
    void moveRequested(int by);
    void evenRequested();
    void overlapRequested();

private:
    QLayout* header();
    QLayout* helpers();

    ItemList* m_list;
    QToolButton *m_up, *m_down, *m_remove;
    QLabel* m_message;
};

} // namespace esm
