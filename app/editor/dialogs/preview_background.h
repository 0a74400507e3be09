#pragma once

#include "core/render/renderer.h"

#include <QWidget>

namespace esm {

/// A picture in a dialog lies on the dialog's own ground.
inline void setBackground(RenderScene& scene, const QWidget& dialog) {
    const QColor ground = dialog.palette().color(QPalette::Base);
    scene.backgroundTop = scene.backgroundBottom = {static_cast<std::uint8_t>(ground.red()),
                                                    static_cast<std::uint8_t>(ground.green()),
                                                    static_cast<std::uint8_t>(ground.blue())};
}

} // namespace esm
