#include "app/editor/tools/size_keys.h"

#include <QShortcut>

#include <utility>

namespace esm {

void sizeByBrackets(QWidget& seen, const std::function<void(double factor)>& resize) {
    for (const auto& [key, factor] : {std::pair(Qt::Key_BracketLeft, 0.8), {Qt::Key_BracketRight, 1.25}})
        QObject::connect(new QShortcut(key, &seen), &QShortcut::activated, &seen,
                         [resize, factor = factor] { resize(factor); });
}

} // namespace esm
