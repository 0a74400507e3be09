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
    if (!buddy) return label;
    // The underlined letter is drawn by itself, without the kerning that the whole text is measured with.
    QFont font = label->font();
    font.setKerning(false);
    label->setFont(font);
    return label;
}

} // namespace esm
