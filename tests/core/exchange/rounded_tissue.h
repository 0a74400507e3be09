#pragma once

#include "core/model/tissue_model.h"
#include "tests/support/same_project.h"

#include <gtest/gtest.h>

#include <vector>

namespace esm {

inline double rounded(double value) {
    return static_cast<double>(static_cast<float>(value));
}

inline std::vector<double> rounded(std::vector<double> values) {
    for (double& value : values)
        value = rounded(value);
    return values;
}

inline std::vector<Eigen::Vector3d> rounded(std::vector<Eigen::Vector3d> points) {
    for (Eigen::Vector3d& point : points)
        point = point.cast<float>().cast<double>();
    return points;
}

inline void expectSameBinding(const Binding& package, const Binding& project) {
    EXPECT_EQ(package.surface, project.surface);
    EXPECT_EQ(package.lines, project.lines);
    EXPECT_EQ(package.vertices.starts, project.vertices.starts);
    EXPECT_EQ(package.vertices.nodes, project.vertices.nodes);
    EXPECT_EQ(package.vertices.shares, rounded(project.vertices.shares));
}

inline void expectSameLattice(const Lattice& package, const Lattice& project) {
    EXPECT_EQ(package.filling, project.filling);
    EXPECT_EQ(package.tetrahedra, project.tetrahedra);
    EXPECT_EQ(package.surface, project.surface);
    EXPECT_EQ(package.springShares, rounded(project.springShares));
}

inline void expectSameSheet(const SheetShares& package, const SheetShares& project) {
    EXPECT_EQ(package.springs, rounded(project.springs));
    EXPECT_EQ(package.nodes, rounded(project.nodes));
}

/// A package holds a project's tissue in 32-bit numbers.
inline void expectSameTissue(const TissueModel& package, const TissueModel& project) {
    EXPECT_EQ(package.network->restPositions, rounded(project.network->restPositions));
    EXPECT_EQ(package.network->vertexNodes, project.network->vertexNodes);
    ASSERT_EQ(package.network->binding.has_value(), project.network->binding.has_value());
    if (project.network->binding) expectSameBinding(*package.network->binding, *project.network->binding);
    ASSERT_EQ(package.network->sheet.has_value(), project.network->sheet.has_value());
    if (project.network->sheet) expectSameSheet(*package.network->sheet, *project.network->sheet);
    ASSERT_EQ(package.network->lattice.has_value(), project.network->lattice.has_value());
    if (project.network->lattice) expectSameLattice(*package.network->lattice, *project.network->lattice);
    ASSERT_EQ(package.network->springs.size(), project.network->springs.size());
    for (std::size_t i = 0; i < package.network->springs.size(); ++i) {
        const Spring &a = package.network->springs[i], &b = project.network->springs[i];
        EXPECT_TRUE(a.first == b.first && a.second == b.second && a.restLength == rounded(b.restLength)) << i;
    }
    EXPECT_EQ(package.mass, rounded(project.mass));
    EXPECT_EQ(package.springConstant, rounded(project.springConstant));
    EXPECT_EQ(package.viscosity, rounded(project.viscosity));
    ASSERT_EQ(package.ownValues.size(), hasOwnValues(project) ? project.ownValues.size() : 0);
    for (std::size_t i = 0; i < package.ownValues.size(); ++i) {
        EXPECT_EQ(package.ownValues[i].springConstant, rounded(project.ownValues[i].springConstant)) << i;
        EXPECT_EQ(package.ownValues[i].viscosity, rounded(project.ownValues[i].viscosity)) << i;
    }
    expectSameStiffening(package.stiffening, project.stiffening);
    ASSERT_EQ(package.hinges.size(), project.hinges.size());
    for (std::size_t i = 0; i < package.hinges.size(); ++i) {
        EXPECT_EQ(package.hinges[i].nodes, project.hinges[i].nodes);
        EXPECT_EQ(package.hinges[i].stiffness, rounded(project.hinges[i].stiffness));
        EXPECT_EQ(package.hinges[i].viscosity, rounded(project.hinges[i].viscosity));
    }
    EXPECT_EQ(package.fixedNodes, project.fixedNodes);
    ASSERT_EQ(package.tethers.size(), project.tethers.size());
    for (std::size_t i = 0; i < package.tethers.size(); ++i) {
        EXPECT_EQ(package.tethers[i].node, project.tethers[i].node);
        EXPECT_EQ(package.tethers[i].springConstant, rounded(project.tethers[i].springConstant));
        EXPECT_EQ(package.tethers[i].viscosity, rounded(project.tethers[i].viscosity));
    }
}

} // namespace esm
