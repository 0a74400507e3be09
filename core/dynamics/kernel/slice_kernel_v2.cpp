#include "core/dynamics/kernel/vectors_v2.h"

#include "core/dynamics/kernel/hinge_functions.h"

namespace esm::kernel::v2 {

const SliceFunctions<float> floatFunctions = sliceFunctions<float>();
const SliceFunctions<double> doubleFunctions = sliceFunctions<double>();

} // namespace esm::kernel::v2
