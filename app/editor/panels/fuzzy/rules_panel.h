#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/edits/system_reach.h"
#include "app/editor/panels/fuzzy/rule_drafts.h"
#include "core/fuzzy/system_warnings.h"
#include "widgets/fuzzy/rule_notes.h"
#include "widgets/fuzzy/rule_table.h"
#include "widgets/fuzzy/rule_text_edit.h"

#include <QAbstractButton>
#include <QLabel>
#include <QStackedWidget>
#include <QTimer>

namespace esm {

/// The rules of the selected region's fuzzy system, as text or as a table. The text is what is edited; the
/// table shows it and writes to it. As long as all of it can be read it is in force, each run of typing an
/// edit. What cannot be read is not in force: the rules before stay so, and the text stays until it is mended
/// or put back, also while another region is selected or the system is edited elsewhere.
class RulesPanel : public QWidget {
    Q_OBJECT

public:
    RulesPanel(Document& document, Selection& selection, SystemReach& reach, QWidget* parent = nullptr);

    RuleTextEdit* text() const { return m_text; }
    RuleTable* table() const { return m_table; }
    /// Whether there is text that is not in force.
    bool isUnfinished() const { return m_system && !m_isInForce; }
    /// After this time without a key what follows is another edit.
    void setPause(std::chrono::milliseconds pause) { m_rest->setInterval(pause); }
    /// Whether a key now would go on with the latest edit.
    bool isRunOpen() const { return m_rest->isActive(); }

private:
    QWidget* buildTop();
    void connectParts();
    void follow(const EditedSystem& edited = {});
    void leaveOrgan();
    void followSystem(const FuzzySystem& before);
    void showSystem();
    void showText(const QString& text);
    void takeText();
    void takeTable(const QStringList& lines);
    void read();
    void apply();
    void finishRun();
    void undo();
    void redo();
    void putBack();
    void showAll();
    void check();
    void showTable();
    void showState();
    void tellUnfinished();
    void showNotes();
    void goTo(int line, int column);
    QString stateText() const;
    QString firstMistake() const;
    FuzzySystem written() const;

    Document& m_document;
    Selection& m_selection;
    SystemReach& m_reach;
    QStackedWidget* m_views; ///< text, table
    RuleTextEdit* m_text;
    RuleTable* m_table;
    QAbstractButton *m_asText, *m_asTable, *m_apply, *m_putBack;
    QLabel* m_state;
    RuleNotes* m_notes;
    QTimer *m_rest, *m_check;

    std::shared_ptr<const FuzzySystem> m_system; ///< in force
    RulesReading m_reading;                      ///< of the text
    QString m_obstacle;                          ///< why what was read cannot be in force
    QString m_refusal;                           ///< of what was pasted
    bool m_isInForce = true;
    bool m_isRunning = false; ///< what is typed belongs to the edit made last
    std::vector<SystemWarning> m_warnings;
    std::shared_ptr<const FuzzySystem> m_warned; ///< that the warnings are about
    std::shared_ptr<const TriangleMesh> m_organ;
    RuleDrafts m_drafts; ///< text that is left, not in force
};

} // namespace esm
