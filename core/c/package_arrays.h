#pragma once

#include "core/c/esm_package.h"
#include "core/exchange/package/packaged_tissue.h"

#include <memory>

namespace esm {

/// The numbers of points, triangles and the like, one after the other; null where there are none.
template<class Element> const auto* numbersIn(const std::vector<Element>& elements) {
    return elements.empty() ? nullptr : elements.front().data();
}

/// A package, and the arrays that programs in C see of it. They point into the package and into lists of
/// their own, so that a copy would point elsewhere.
class PackageArrays {
public:
    explicit PackageArrays(std::shared_ptr<const PackagedTissue> package);
    PackageArrays(const PackageArrays&) = delete;
    PackageArrays& operator=(const PackageArrays&) = delete;

    const std::shared_ptr<const PackagedTissue>& package() const { return m_package; }
    const EsmModel& model() const { return m_model; }

private:
    /// Nodes and values of what the model holds as structs: springs, tethers, hinges.
    struct Lists {
        std::vector<std::uint32_t> nodes;
        std::vector<double> lengths, constants, viscosities;
    };

    void addSprings();
    void addTethers();
    void addHinges();
    void addSurface();
    void addBinding();
    void addFillings();

    std::shared_ptr<const PackagedTissue> m_package;
    Lists m_springs, m_tethers, m_hinges;
    std::vector<std::uint32_t> m_lines, m_filledParts;
    std::vector<double> m_fillingStiffnesses;
    EsmModel m_model{};
};

} // namespace esm

struct EsmPackage {
    esm::PackageArrays arrays;
};
