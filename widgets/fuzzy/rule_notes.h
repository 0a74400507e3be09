#pragma once

#include <QListWidget>

#include <vector>

namespace esm {

/// What is to be said about rules.
struct RuleNote {
    enum class Kind { Mistake, Warning, Quiet };

    Kind kind;
    QString text;
    int line = -1;  ///< that it speaks of, from 0; below zero where it is none
    int column = 1; ///< in letters, from 1
};

/// Notes about rules, one below the other, each as many lines as it needs. A click or Enter asks for the
/// place.
class RuleNotes : public QListWidget {
    Q_OBJECT

public:
    explicit RuleNotes(QWidget* parent = nullptr);

    void setNotes(const std::vector<RuleNote>& notes);

signals:
    void placePicked(int line, int column);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showNotes();
    void pick(const QListWidgetItem* item);

    std::vector<RuleNote> m_notes;
};

} // namespace esm
