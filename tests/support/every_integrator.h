#pragma once

#include "core/model/integrators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

/// Names a test after the integrator that it is run with, in letters that such names may have.
inline std::string nameOfIntegratorTest(const testing::TestParamInfo<esm::Integrator>& tested) {
    std::string name = integratorName(tested.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}
