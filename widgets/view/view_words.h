#pragma once

#include "core/render/camera.h"
#include "widgets/view/overlay.h"

#include <QString>

namespace esm {

/// "seen from the front": the side that the camera looks from more than from any other.
QString sideWords(const Camera& camera);
/// "Spring constant from 0 to 120 N/m", or the names of the colours.
QString legendWords(const ViewLegend& legend);

} // namespace esm
