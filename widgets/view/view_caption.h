#pragma once

#include <QLabel>

namespace esm {

/// A word at the top of a view that says what is seen there. Takes no room from the view, and no mouse.
class ViewCaption : public QLabel {
    Q_OBJECT

public:
    ViewCaption(QWidget& view, const QString& text);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void place();

    QWidget& m_view;
};

} // namespace esm
