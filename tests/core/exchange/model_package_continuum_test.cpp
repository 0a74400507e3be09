#include "tests/core/exchange/model_package_fixture.h"

#include "core/project/continuum.h"
#include "tests/core/exchange/rounded_tissue.h"
#include "tests/core/exchange/strangers_reader.h"
#include "tests/support/exchange_projects.h"

#include <numeric>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ModelPackageFile, HoldsTheContinuumOfASheet) {
    const Project project = sheetProject();
    const auto material = exported(project).material;
    ASSERT_TRUE(material);
    EXPECT_EQ(material->thickness, project.base.wallThickness);
    EXPECT_DOUBLE_EQ(material->poissonsRatio, 1.0 / 3);
    const TissueModel tissue = evaluateModel(project);
    for (std::size_t node = 0; node < tissue.mass.size(); ++node)
        EXPECT_NEAR(material->youngsModulus[node],
                    2 / std::sqrt(3.0) * tissue.springConstant[node] / project.base.wallThickness,
                    1e-6 * material->youngsModulus[node]);
    expectReadIndependently(project, m_folder.path());
}

TEST_F(ModelPackageFile, HoldsTheContinuumOfABody) {
    const Project project = filledProject();
    const auto material = exported(project).material;
    ASSERT_TRUE(material);
    EXPECT_FALSE(material->thickness);
    EXPECT_NEAR(material->poissonsRatio, 0.25, 1e-9);
    expectReadIndependently(project, m_folder.path());
}

TEST_F(ModelPackageFile, KnowsNoContinuumOfOtherSprings) {
    for (const Project& project : {richProject(), bareProject(), boundProject({Detail::Kind::Rigid, 0})})
        EXPECT_FALSE(exported(project).material);
}

TEST_F(ModelPackageFile, AContinuumThatIsNoneIsRefused) {
    exportPackage(sheetProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* key, const Json& value) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"]["material"][key] = value;
        rewrite(glb);
        EXPECT_THROW(loadPackagedTissue(m_file), FileError);
        return loadingError();
    };
    EXPECT_THAT(refusal("poissonsRatio", 0.6), HasSubstr("Poisson's ratio must be"));
    EXPECT_THAT(refusal("thickness", 0), HasSubstr("the thickness must be"));
    EXPECT_THAT(refusal("density", nullptr), HasSubstr("density is missing"));
    EXPECT_THAT(refusal("youngsModulus", 9999), HasSubstr("youngsModulus"));
}

TEST_F(ModelPackageFile, TellsSpringsOfTheSurfaceFromThoseWithin) {
    const Project project = filledProject();
    exportPackage(project, m_file);
    const Glb glb = parseGlb(readFile(m_file));
    std::vector<std::string> problems;
    const Json& place = glb.json["extensions"]["ESM_spring_mass"]["springs"]["kind"];
    const std::vector<std::uint32_t> kinds =
        GltfArrayReader(glb, problems)
            .indices(JsonReader(place, "kind", problems), project.network->springs.size(), 2);
    EXPECT_THAT(problems, testing::IsEmpty());
    const auto within = static_cast<std::size_t>(std::accumulate(kinds.begin(), kinds.end(), 0U));
    // A lattice has every edge of its surface among its springs.
    EXPECT_EQ(kinds.size() - within, uniqueEdges(project.network->lattice->surface).size());
    EXPECT_GT(within, 0U);
}

TEST_F(ModelPackageFile, HoldsWhatPressesFromWithin) {
    Project project = sheetProject();
    const auto pressed = [&](std::vector<PartPressure> pressures) {
        project.scene.pressures = std::move(pressures);
        exportPackage(project, m_file);
        return loadPackage(m_file);
    };
    EXPECT_THAT(pressed({}).pressures, testing::IsEmpty());
    const std::vector<PartPressure> pressures{{0, {{0, 0}, {1.0 / 3, 400}, {2, -100}}}};
    const ModelPackage package = pressed(pressures);
    EXPECT_EQ(package.pressures, pressures);
    ASSERT_EQ(package.tissue.cavities.size(), 1U);
    EXPECT_EQ(package.tissue.cavities[0].largestPressure, 400);
    EXPECT_EQ(loadPackagedTissue(m_file).pressures, pressures);
    expectReadIndependently(project, m_folder.path());
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"]["pressures"][0]["part"] = 7;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("no part 7"));
}

} // namespace
} // namespace esm
