#pragma once

#include "app/editor/dialogs/save_dialog.h"

#include <functional>

namespace esm {

/// Asks where to write what was measured, and writes it; what goes wrong is shown.
/// @return what to say of it in the line at the bottom; empty where nothing was written
QString writeMeasurement(QWidget* window, const NewFile& asked, const QString& failure,
                         const std::function<void(const std::filesystem::path&)>& writing);

} // namespace esm
