#pragma once

#include "core/exchange/package/glb.h"
#include "core/support/errors.h"
#include "tests/core/exchange/export_package.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace esm {

class ModelPackageFile : public testing::Test {
protected:
    ModelPackage exported(const Project& project) const {
        exportPackage(project, m_file);
        EXPECT_THAT(validatePackage(m_file), testing::IsEmpty());
        return loadPackage(m_file);
    }

    /// Without check sums, as who changes a package by hand leaves them out: what else is wrong is told then.
    void rewrite(Glb glb) const {
        nlohmann::ordered_json& extensions = glb.json["extensions"];
        if (extensions.contains("ESM_spring_mass")) extensions["ESM_spring_mass"].erase("checksums");
        overwrite(m_file, writeGlb(glb));
    }

    std::string loadingError() const {
        try {
            loadPackage(m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "loaded";
    }

    std::string exportError(const Project& project) const {
        try {
            exportPackage(project, m_file);
        } catch (const FileError& error) {
            return error.what();
        }
        return "exported";
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "organ.glb";
};

} // namespace esm
