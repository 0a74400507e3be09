#include "core/dynamics/kernel/vectors_v3.h"

#include "core/dynamics/kernel/hinge_functions.h"

namespace esm::kernel::v3 {

const SliceFunctions<float> floatFunctions = sliceFunctions<float>();
const SliceFunctions<double> doubleFunctions = sliceFunctions<double>();

} // namespace esm::kernel::v3
