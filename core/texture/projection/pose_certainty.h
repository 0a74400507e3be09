#pragma once

#include "core/texture/projection/camera_fit.h"

namespace esm {

/// How sure a pose is: the truth lies so near with a probability of 95 %, the clicks' noise being normal and
/// the camera usual where it is not known.
struct PoseCertainty {
    double eye = 0;  ///< of the organ's unit, from the eye
    double turn = 0; ///< degrees, of the whole turn
};

/// @param fit the likeliest camera, all that is `unknown` being free
/// @param used the one whose pose is judged
PoseCertainty poseCertainty(const CameraFit& fit, const CameraProblem& problem, const CameraFreedom& unknown,
                            const PinholeCamera& used);

} // namespace esm
