#pragma once

#include "core/model/integrators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

/// Names a test after the integrator that it is run with, in letters that such names may have.
inline std::string nameOfIntegratorTest(const testing::TestParamInfo<esm::Integrator>& tested) {
    std::string name = integratorName(tested.param);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// A test that tries some of all integrators asks for them, so that one which is added is among them.
template<class Predicate> std::vector<esm::Integrator> integratorsThat(const Predicate& predicate) {
    std::vector<esm::Integrator> found;
    std::copy_if(esm::allIntegrators.begin(), esm::allIntegrators.end(), std::back_inserter(found),
                 predicate);
    return found;
}
inline std::vector<esm::Integrator> explicitIntegrators() {
    return integratorsThat(esm::isExplicit);
}

/// Whether it bears only short steps, of which a few show the sanitizers as much as many.
inline bool takesShortSteps(esm::Integrator integrator) {
    return isExplicit(integrator) || integrator == esm::Integrator::Propagation;
}
