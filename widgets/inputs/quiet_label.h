#pragma once

#include <QLabel>
#include <QVariant>

namespace esm {

/// Words in the quiet colour: a caption, a remark.
/// @param buddy what the letter after "&" in the text goes to; null: words alone
inline QLabel* quietLabel(const QString& text, QWidget* parent, QWidget* buddy = nullptr) {
    auto* label = new QLabel(text, parent);
    label->setProperty("quiet", true);
    label->setBuddy(buddy);
    // An underlined letter is drawn by itself, and the rest a pixel or two further right than it was
    // measured.
    if (buddy) label->setContentsMargins(0, 0, 2, 0);
    return label;
}

} // namespace esm
