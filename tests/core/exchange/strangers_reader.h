#pragma once

#include "core/exchange/fields_json.h"
#include "core/exchange/project/project_file.h"
#include "core/support/atomic_file.h"
#include "tests/core/exchange/export_package.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace esm {

/// The reader that shares no code with the program, on the package and the project it was made from.
inline void expectReadIndependently(const Project& project, const std::filesystem::path& folder,
                                    const HandoverMeans& means = {}) {
    const std::filesystem::path package = folder / "organ.glb", saved = folder / "organ.esm",
                                expected = folder / "tissue.json";
    exportPackage(project, package, means);
    saveProject(project, saved);
    const TissueModel tissue = evaluateModel(project);
    nlohmann::ordered_json json{
        {"mass", tissue.mass},
        {"spring_constant", tissue.springConstant},
        {"viscosity", tissue.viscosity},
        {"stiffening", tissue.stiffening ? writtenFields(*tissue.stiffening) : nlohmann::ordered_json()},
        {"tethers", nlohmann::ordered_json::array()},
        {"fixed", tissue.fixedNodes}};
    for (const Tether& tether : tissue.tethers)
        json["tethers"].push_back({tether.node, tether.springConstant, tether.viscosity});
    writeFileAtomically(expected, json.dump());
    const std::string command = std::string("python3 '") + ESM_SOURCE_DIR + "/tests/cli/read_package.py' '" +
                                package.string() + "' --project '" + saved.string() + "' --tissue '" +
                                expected.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

} // namespace esm
