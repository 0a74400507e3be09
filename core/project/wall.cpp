#include "core/project/wall.h"

#include <cmath>

namespace esm {

double youngsModulusOfWall(double springConstant, double thickness) {
    return 2 * springConstant / (std::sqrt(3.0) * thickness);
}

double springConstantOfWall(double youngsModulus, double thickness) {
    return std::sqrt(3.0) * thickness * youngsModulus / 2;
}

} // namespace esm
