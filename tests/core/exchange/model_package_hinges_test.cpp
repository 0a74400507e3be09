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

Project wallProject() {
    Project project = biphasicProject();
    project.base.resistsBending = true;
    project.base.wallThickness = 0.004;
    return project;
}

TEST_F(ModelPackageFile, HoldsTheHingesOfAWall) {
    const Project project = wallProject();
    exportPackage(project, m_file);
    const ModelPackage package = loadPackage(m_file);
    EXPECT_FALSE(package.tissue.hinges.empty());
    expectSameTissue(package.tissue, evaluateModel(project));
    EXPECT_EQ(package.base, project.base);
    EXPECT_EQ(loadPackagedTissue(m_file).tissue.hinges, package.tissue.hinges);
}

TEST_F(ModelPackageFile, HoldsTheHingesOfAWallOfTheUsualThickness) {
    Project project = wallProject();
    project.base.wallThickness = usualWallThickness;
    exportPackage(project, m_file);
    EXPECT_FALSE(loadPackage(m_file).tissue.hinges.empty());
}

TEST_F(ModelPackageFile, HingesThatAreNoneAreRefused) {
    exportPackage(wallProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* group, const char* key, const Json& value) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"][group][key] = value;
        rewrite(glb);
        EXPECT_THROW(loadPackagedTissue(m_file), FileError) << key << value;
        return loadingError();
    };
    const Json extension = whole.json["extensions"]["ESM_spring_mass"];
    EXPECT_THAT(refusal("hinges", "count", 7), HasSubstr("hinges.nodes"));
    EXPECT_THAT(refusal("hinges", "nodes", extension["springs"]["nodes"]), HasSubstr("hinges.nodes"));
    EXPECT_THAT(refusal("hinges", "stiffness", extension["nodes"]["mass"]), HasSubstr("hinges.stiffness"));
    EXPECT_THAT(refusal("hinges", "viscosity", "soft"), HasSubstr("hinges.viscosity"));
}

TEST_F(ModelPackageFile, AVersionThatKnewNoHingesIsRefused) {
    exportPackage(wallProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    EXPECT_EQ(glb.json["extensions"]["ESM_spring_mass"]["version"], 9);
    glb.json["extensions"]["ESM_spring_mass"]["version"] = 8;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("should be 9"));
}

} // namespace
} // namespace esm
