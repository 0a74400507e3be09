#pragma once

#include "core/authoring/preset_changes.h"

#include <QString>
#include <QWidget>

namespace esm {

/// Lists what a preset would change, from what to what, and asks whether it may.
/// @param target whose tissue it is for
bool mayApplyPreset(QWidget& window, const TissuePreset& preset, const QString& target,
                    const std::vector<PresetChange>& changes);

} // namespace esm
