#pragma once

#include "core/texture/photo/lens.h"

#include <functional>

class QString;
class QWidget;

namespace esm {

/// Asks for a lens file and hands the lens on; says why where it cannot be read.
void openLens(QWidget* window, const std::function<void(const Lens&)>& use);
/// Asks for a file and writes the lens there, for other photos of the same endoscope.
void saveLens(QWidget* window, const QString& suggestedName, const Lens& lens);

} // namespace esm
