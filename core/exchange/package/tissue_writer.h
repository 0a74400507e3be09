#pragma once

#include "core/exchange/package/glb.h"
#include "core/model/equivalent_material.h"
#include "core/model/tissue_model.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace esm {

/// Writes the groups of a package's extension that hold tissue, their numbers into arrays.
class TissueWriter {
public:
    /// Both outlive the writer.
    TissueWriter(const TissueModel& tissue, GltfArrays& arrays)
        : m_tissue(tissue), m_network(*tissue.network), m_arrays(arrays) {}

    nlohmann::ordered_json nodes();
    nlohmann::ordered_json springs();
    nlohmann::ordered_json tethers();
    nlohmann::ordered_json fixedNodes();
    /// Whether fluid that resists is in some part.
    bool hasFillings() const;
    nlohmann::ordered_json fillings() const;
    /// Precondition: the tissue has hinges.
    nlohmann::ordered_json hinges();
    /// Precondition: the network has a binding.
    nlohmann::ordered_json binding();
    /// Precondition: the network has a sheet.
    nlohmann::ordered_json sheet();
    /// Precondition: the network has a lattice.
    nlohmann::ordered_json lattice();
    /// An array of the kinds of springs. Precondition: the network has a lattice.
    std::size_t springKinds();
    nlohmann::ordered_json material(const EquivalentMaterial& material);

    /// Numbers as a package holds them. What is beyond their range is a problem.
    std::vector<float> floats(const std::vector<double>& values, const char* what);
    std::vector<float> coordinates(const std::vector<Eigen::Vector3d>& points, const char* what);

    /// Accessors that others may use, once their group is written.
    std::size_t nodePositions() const { return m_nodePositions; }
    std::size_t springNodes() const { return m_springNodes; }
    const std::vector<std::string>& problems() const { return m_problems; }

private:
    std::size_t addScalars(const std::vector<double>& values, const char* what) {
        return m_arrays.addFloats(floats(values, what), GltfType::Scalar);
    }

    const TissueModel& m_tissue;
    const SpringNetwork& m_network;
    GltfArrays& m_arrays;
    std::size_t m_nodePositions = 0, m_springNodes = 0;
    std::vector<std::string> m_problems;
};

} // namespace esm
