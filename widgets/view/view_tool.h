#pragma once

#include <QString>

namespace esm {

/// What the left mouse button does in the organ's view.
enum class ViewTool {
    Select,     ///< turns the view; a click picks
    Pull,       ///< pulls the tissue
    Instrument, ///< moves the sphere instrument over the surface
    Region,     ///< moves, sizes and turns a region's ellipsoid, and widens its rim
    Place,      ///< turns the view; a click lays a region on the surface
    Projector,  ///< moves and scales a photo's projector
    Landmark,   ///< turns the view; a click says where a point of the photo lies
    Brush       ///< paints on the surface
};

/// What only this tool does, in one line.
QString toolUse(ViewTool tool);
/// The same with what else helps while the tool is in hand.
QString toolHint(ViewTool tool);

} // namespace esm
