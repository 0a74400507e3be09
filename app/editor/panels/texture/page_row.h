#pragma once

#include <QHBoxLayout>
#include <QWidget>

namespace esm {

inline constexpr int pageNumberWidth = 100; ///< pixels, at most of a field for a number

/// The row of controls that a page above a photo is.
inline QHBoxLayout* pageRow(QWidget* page) {
    auto* row = new QHBoxLayout(page);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    return row;
}

} // namespace esm
