#pragma once

#include "tests/support/tissue_models.h"

namespace benchmarks {

/// Tissue of 10 242 nodes, published parameters, half of it stiffer; the slider goes up and down.
class Slider {
public:
    Slider() {
        m_models[0] = tissue::fromMesh(tissue::sphereMesh(5, 0.05), {16.26, 2.877, 1e-4});
        for (std::size_t i = 0; i < m_models[0].mass.size(); ++i) {
            m_models[0].springConstant[i] *= i % 1000 < 500 ? 5 : 1;
            m_models[0].viscosity[i] *= i % 700 < 300 ? 0.2 : 1;
        }
        m_models[1] = m_models[0];
        for (double& springConstant : m_models[1].springConstant)
            springConstant *= 1.1;
    }
    const esm::TissueModel& move() { return m_models[m_moves++ % 2]; }

private:
    esm::TissueModel m_models[2];
    std::size_t m_moves = 0;
};

} // namespace benchmarks
