#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/package/glb.h"
#include "tests/core/exchange/export_package.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/support/exchange_projects.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ModelPackageFile, KeepsHowASheetSharesItsTissueOut) {
    const Project project = sheetProject();
    exportPackage(project, m_file);
    expectSameTissue(loadPackage(m_file).tissue, evaluateModel(project));
}

TEST_F(ModelPackageFile, SharesOfASheetThatAreNoneAreRefused) {
    exportPackage(sheetProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* key, const char* other) {
        Glb glb = whole;
        Json& extension = glb.json["extensions"]["ESM_spring_mass"];
        extension["sheet"][key] = Json(extension["nodes"][other]);
        rewrite(glb);
        EXPECT_THROW(loadPackagedTissue(m_file), FileError) << key;
        return loadingError();
    };
    EXPECT_THAT(refusal("springShares", "mass"), HasSubstr("sheet.springShares"));
    EXPECT_THAT(refusal("nodeShares", "restPosition"), HasSubstr("should be of type SCALAR"));
}

} // namespace
} // namespace esm
