#pragma once

#include "core/fuzzy/system_edits.h"

#include <QAction>
#include <QComboBox>
#include <QToolButton>

namespace esm {

/// Chooses a variable of a fuzzy system, inputs and outputs apart, and asks for what can be done to it and to
/// their list.
class VariableChoice : public QWidget {
    Q_OBJECT

public:
    explicit VariableChoice(QWidget* parent = nullptr);

    /// Shows a system's variables and the one chosen, announcing nothing. Precondition: it is there.
    void show(const FuzzySystem& system, const VariablePlace& chosen);

signals:
    void chosen(const esm::VariablePlace& place);
    void addRequested(esm::FuzzySide side);
    void renameRequested();
    void removeRequested();
    /// One place up (−1) or down (+1).
    void moveRequested(int by);

private:
    void addVariables(const QString& title, FuzzySide side, const std::vector<FuzzyVariable>& variables);
    void enableActions(const FuzzySystem& system, const VariablePlace& chosen);

    QStringList m_names; ///< in the list
    QComboBox* m_list;
    QToolButton* m_more;
    QAction *m_addInput, *m_addOutput, *m_rename, *m_up, *m_down, *m_remove;
};

} // namespace esm
