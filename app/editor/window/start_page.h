#pragma once

#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace esm {

struct Actions;

/// What the window shows before there is an organ: ways to begin, samples, and the files that were opened
/// last. Scrolls where it has no room.
class StartPage : public QScrollArea {
    Q_OBJECT

public:
    explicit StartPage(const Actions& actions, QWidget* parent = nullptr);

signals:
    /// @param file its full path
    void recentChosen(const QString& file);
    void firstStepsAsked();

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* waysToBegin(const Actions& actions);
    void fillRecent();

    QVBoxLayout* m_recent;
};

} // namespace esm
