#pragma once

#include "app/editor/dialogs/save_dialog.h"
#include "core/exchange/charts/drawing.h"

#include <functional>

namespace esm {

/// Asks where to write what was measured, and writes it; what goes wrong is shown.
/// @return what to say of it in the line at the bottom; empty where nothing was written
QString writeMeasurement(QWidget* window, const NewFile& asked, const QString& failure,
                         const std::function<void(const std::filesystem::path&)>& writing);

/// The same of a table, in a .csv, and of a chart, in a .png or .svg.
QString saveTable(QWidget* window, const Document& document, const std::function<std::string()>& table);
QString saveChart(QWidget* window, const Document& document, const std::function<Drawing()>& chart);

} // namespace esm
