#include "core/dynamics/elimination/panel_functions.h"

namespace esm::kernel::v2 {

const PanelFunctions panelFunctions{solveLowerPanel, solveUpperPanel};

} // namespace esm::kernel::v2
