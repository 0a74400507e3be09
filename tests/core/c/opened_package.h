#pragma once

#include "core/c/esm_package.h"
#include "core/exchange/package/packaged_tissue.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

namespace esm {

/// One of the packages of `tests/data`.
inline std::filesystem::path keptPackage(const std::string& name) {
    return std::filesystem::path(ESM_SOURCE_DIR) / "tests/data/packages" / name;
}

struct FreePackage {
    void operator()(EsmPackage* package) const { esmFreePackage(package); }
};
struct FreeSimulation {
    void operator()(EsmSimulation* simulation) const { esmFreeSimulation(simulation); }
};
using OwnedPackage = std::unique_ptr<EsmPackage, FreePackage>;
using OwnedSimulation = std::unique_ptr<EsmSimulation, FreeSimulation>;

inline OwnedPackage openedPackage(const std::filesystem::path& file) {
    EsmError error;
    OwnedPackage package(esmOpenPackage(file.c_str(), &error));
    EXPECT_STREQ(error.text, "");
    return package;
}

} // namespace esm
