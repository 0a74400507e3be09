#pragma once

#include "widgets/inputs/number_field.h"

namespace esm {

/// The same quantity in a field whose caption names the unit.
NumberFormat withoutUnit(NumberFormat format);

/// Lengths and places in m, shown in mm.
NumberFormat lengthFormat(double minimum);
/// The shortest length that makes sense for an axis or an edge, m.
constexpr double smallestLength = 1e-5;

NumberFormat angleFormat(); ///< whole degrees
/// How three angles make one turn.
QString turnedToolTip();
NumberFormat modulusFormat();                                 ///< Pa, shown in kPa
NumberFormat timeFormat();                                    ///< s
NumberFormat forceFormat();                                   ///< N, above zero
NumberFormat massFormat();                                    ///< kg, above zero
NumberFormat percentFormat(double minimum, double maximum);   ///< shares of one, shown in percent
NumberFormat wholePercentFormat(double maximum, double step); ///< from 0, in whole percent
NumberFormat shareFormat();                                   ///< 0 to 1, in whole percent
NumberFormat pixelFormat();                                   ///< whole pixels

} // namespace esm
