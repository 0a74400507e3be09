#pragma once

#include <Eigen/Core>

namespace esm {

/// What an instrument and the tissue did to each other.
struct InstrumentTouch {
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero(); ///< N·s, of the tissue on the instrument
    bool touched = false;                              ///< what can give way
    bool metImmovable = false; ///< fixed or led nodes that it passed, which give no impulse
};

} // namespace esm
