#pragma once

#include <QString>

#include <string>

namespace esm {

/// A remark of the core, which begins small, as people read it by itself.
inline QString sentence(const std::string& remark) {
    QString text = QString::fromStdString(remark);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

} // namespace esm
