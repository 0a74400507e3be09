#pragma once

#include <QString>

namespace esm {

/// What the left mouse button does in the organ's view.
enum class ViewTool {
    Select,     ///< turns the view; a click picks
    Pull,       ///< pulls the tissue
    Instrument, ///< moves the sphere instrument over the surface
    Region,     ///< moves and scales a region's ellipsoid
    Projector   ///< moves and scales a photo's projector
};

/// One line on how to use the tool.
QString toolHint(ViewTool tool);

} // namespace esm
