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

TEST_F(ModelPackageFile, KeepsWhatFillsTheOrgan) {
    const Project project = filledProject();
    exportPackage(project, m_file);
    const ModelPackage package = loadPackage(m_file);
    expectSameTissue(package.tissue, evaluateModel(project));
    EXPECT_EQ(simulatedSurface(package.mesh, *package.tissue.network), project.network->lattice->surface);
}

TEST_F(ModelPackageFile, ALatticeThatIsNoneIsRefused) {
    exportPackage(filledProject(), m_file);
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* key, const Json& value) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"]["lattice"][key] = value;
        rewrite(glb);
        EXPECT_THROW(loadPackagedTissue(m_file), FileError) << key << value;
        return loadingError();
    };
    const Json extension = whole.json["extensions"]["ESM_spring_mass"];
    EXPECT_THAT(refusal("kind", "foam"), HasSubstr("lattice.kind"));
    EXPECT_THAT(refusal("spacing", 0), HasSubstr("the lattice's spacing"));
    EXPECT_THAT(refusal("tetrahedronCount", 1U << 30), HasSubstr("lattice.tetrahedra"));
    EXPECT_THAT(refusal("tetrahedra", extension["lattice"]["triangles"]), HasSubstr("lattice.tetrahedra"));
    EXPECT_THAT(refusal("springShares", extension["nodes"]["mass"]), HasSubstr("lattice.springShares"));
    EXPECT_THAT(refusal("triangleCount", 7), HasSubstr("lattice.triangles"));
    EXPECT_THAT(refusal("tetrahedronCount", 0), HasSubstr("lattice.tetrahedronCount"));
}

TEST_F(ModelPackageFile, ALatticeWithAnotherSurfaceIsRefused) {
    exportPackage(filledProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    Json& lattice = glb.json["extensions"]["ESM_spring_mass"]["lattice"];
    lattice["triangleCount"] = 0;
    rewrite(glb);
    EXPECT_THAT(loadingError(), HasSubstr("lattice.triangles"));
    EXPECT_THROW(loadPackagedTissue(m_file), FileError);
}

} // namespace
} // namespace esm
