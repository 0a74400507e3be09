#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace esm {

/// An element of a scene, as a reader that shares nothing with the writer finds it.
struct SofaElement {
    std::string kind;
    std::map<std::string, std::string> attributes;
    std::size_t depth;

    bool has(const std::string& name) const { return attributes.count(name) > 0; }
    std::string text(const std::string& name) const;
    std::vector<double> numbers(const std::string& name) const;
};

/// A scene's folder, and what SOFA's components would make of it: their forces and matrices, written down
/// from the documentation of each.
class SofaReader {
public:
    explicit SofaReader(const std::filesystem::path& folder);

    const std::vector<SofaElement>& elements() const { return m_elements; }
    std::vector<const SofaElement*> all(const std::string& kind) const;
    const SofaElement& only(const std::string& kind) const;

    using Vectors = std::vector<Eigen::Vector3d>;
    Vectors positions() const;

    /// What the solver takes for forces, N: those of the fields and, up to release 24.06, what fields declare
    /// as Rayleigh damping.
    Vectors forces(const Vectors& positions, const Vectors& velocities) const;
    /// Its matrix of damping times velocities, N.
    Vectors solvedDamping(const Vectors& velocities) const;

private:
    struct VectorSpring {
        std::size_t first, second;
        double stiffness, damping;
        Eigen::Vector3d rest;
    };
    std::vector<VectorSpring> vectorSprings(const SofaElement& field) const;
    bool addsDamping() const;
    void addSprings(const Vectors& positions, const Vectors& velocities, Vectors& forces) const;
    void addRayleighDamping(const Vectors& velocities, Vectors& forces) const;
    void addNodeDamping(const Vectors& velocities, Vectors& forces) const;

    std::filesystem::path m_folder;
    std::vector<SofaElement> m_elements;
};

} // namespace esm
