#pragma once

#include <QHBoxLayout>
#include <QLabel>

namespace esm {

inline constexpr int pageNumberWidth = 100; ///< pixels, at most of a field for a number

/// The row of controls that a page above a photo is.
inline QHBoxLayout* pageRow(QWidget* page) {
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    return row;
}

/// @param buddy null: words alone
inline QLabel* quietLabel(const QString& text, QWidget* buddy, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setProperty("quiet", true);
    label->setBuddy(buddy);
    return label;
}

} // namespace esm
