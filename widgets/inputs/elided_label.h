#pragma once

#include <QLabel>

namespace esm {

/// One line of plain text, cut with an ellipsis where it has no room; the tool tip then says all of it,
/// unless there is another.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

} // namespace esm
