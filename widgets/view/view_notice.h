#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

namespace esm {

/// Something to be said where one looks, at the top of a view: a text, a button that does something about it,
/// and one that takes the notice away. Takes no room from the view, and hides until it has something to say.
/// Several of one view stand one below the other.
class ViewNotice : public QFrame {
    Q_OBJECT

public:
    explicit ViewNotice(QWidget& view);

    /// @param help what the button does; empty: there is no button
    void say(const QString& text, const QString& help, const QString& helpToolTip);

signals:
    void helpAsked();
    void dismissed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void placeAll();
    void place(int left, int right, int top);

    QWidget& m_view;
    QLabel* m_text;
    QPushButton* m_help;
};

} // namespace esm
