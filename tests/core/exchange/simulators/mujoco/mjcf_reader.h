#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace esm {

struct MjcfElement {
    std::string kind;
    std::map<std::string, std::string> attributes;
    std::vector<MjcfElement> children;

    bool has(const std::string& name) const { return attributes.contains(name); }
    const std::string& text(const std::string& name) const { return attributes.at(name); }
    std::vector<double> numbers(const std::string& name) const;
    double number(const std::string& name, double without = 0) const;
    const MjcfElement& only(const std::string& childKind) const; ///< the one child of its kind
    std::vector<const MjcfElement*> all(const std::string& childKind) const;
};

/// A reader of MuJoCo's XML that shares nothing with what writes it, and what MuJoCo's manual says of the
/// elements: slide joints, spatial and fixed tendons.
class MjcfReader {
public:
    using Vectors = std::vector<Eigen::Vector3d>; ///< one per node

    explicit MjcfReader(const std::filesystem::path& file);

    const MjcfElement& model() const { return m_model; }
    const std::vector<const MjcfElement*>& bodies() const { return m_bodies; }
    bool isMovable(std::size_t node) const { return !m_bodies[node]->all("joint").empty(); }
    Vectors positions() const;
    /// N, of joints and tendons, as generalized forces of the joints; none on what has no joints.
    Vectors forces(const Vectors& at, const Vectors& velocities) const;

private:
    struct Motion;
    void addJoints(const Motion& motion, Vectors& forces) const;
    void addSpatial(const MjcfElement& tendon, const Motion& motion, Vectors& forces) const;
    void addFixed(const MjcfElement& tendon, const Motion& motion, Vectors& forces) const;

    MjcfElement m_model;
    std::vector<const MjcfElement*> m_bodies;
    std::map<std::string, std::size_t> m_sites;                              ///< the node of each
    std::map<std::string, std::pair<std::size_t, Eigen::Vector3d>> m_joints; ///< the node and axis of each
};

} // namespace esm
