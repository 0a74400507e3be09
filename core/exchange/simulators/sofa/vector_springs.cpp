#include "core/exchange/simulators/sofa/vector_springs.h"

#include "core/exchange/simulators/xml_text.h"
#include "core/support/numbers.h"

namespace esm {

std::vector<VectorSpring> hingeSprings(const SpringSystem& system) {
    std::vector<VectorSpring> springs;
    for (const SpringSystem::HingeElement& hinge : system.hinges)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = i + 1; j < 4; ++j) {
                const double share = -hinge.weights[i] * hinge.weights[j];
                springs.push_back(
                    {hinge.nodes[i], hinge.nodes[j], share * hinge.springConstant, share * hinge.viscosity});
            }
    return springs;
}

std::vector<VectorSpring> viscousSprings(const SpringSystem& system) {
    std::vector<VectorSpring> springs;
    for (const SpringSystem::Element& spring : system.springs)
        if (spring.viscosity > 0) springs.push_back({spring.first, spring.second, 0, spring.viscosity});
    return springs;
}

std::string xspText(const std::vector<VectorSpring>& springs,
                    const std::vector<Eigen::Vector3d>& restPositions) {
    std::string text = "Xsp 4.0\nnumm " + std::to_string(restPositions.size()) + "\nnums " +
                       std::to_string(springs.size()) + '\n';
    for (std::size_t node = 0; node < restPositions.size(); ++node)
        text += "mass " + std::to_string(node + 1) + " v " + spaced(restPositions[node]) + " 0 0 0 1 0\n";
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const auto& [first, second, springConstant, viscosity] = springs[i];
        // Any length but −1, which the reader would divide the constants by.
        constexpr const char* length = " 0 ";
        text += "lspg " + std::to_string(i + 1) + ' ' + std::to_string(first + 1) + ' ' +
                std::to_string(second + 1) + ' ' + exactText(springConstant) + ' ' + exactText(viscosity) +
                length + spaced(Eigen::Vector3d(restPositions[second] - restPositions[first])) + '\n';
    }
    return text;
}

} // namespace esm
