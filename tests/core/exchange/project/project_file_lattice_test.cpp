#include "tests/core/exchange/project/project_file_fixture.h"

#include "core/project/detail_change.h"
#include "core/solid/filled_body.h"
#include "core/support/byte_order.h"
#include "tests/support/same_project.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ProjectFile, KeepsWhatFillsTheOrgan) {
    const Project project = filledProject();
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
}

TEST_F(ProjectFile, ALatticeOfTetrahedraThatAreNoneIsRefused) {
    const Project project = filledProject();
    const auto refusal = [&](std::size_t place, std::uint32_t number) {
        saveChangedOf(project, project_layout::latticeTetrahedra, [&](auto&, ZipEntry& entry) {
            Bytes bytes;
            appendLittleEndian(bytes, number);
            std::copy(bytes.begin(), bytes.end(),
                      entry.content.begin() + static_cast<std::ptrdiff_t>(4 * place));
        });
        return loadingError();
    };
    const Tetrahedron& first = project.network->lattice->tetrahedra[0];
    EXPECT_THAT(refusal(1, 1U << 20), HasSubstr("lattice/tetrahedra.u32: number 1 is 1048576"));
    EXPECT_THAT(refusal(1, first[0]), HasSubstr("lattice tetrahedron that is flat"));
}

/// Nothing is looked up by numbers that could not be checked.
TEST_F(ProjectFile, ALatticeOverNodesThatAreDamagedIsRefused) {
    saveChangedOf(filledProject(), project_layout::latticeTetrahedra, [](auto& entries, ZipEntry& entry) {
        std::fill(entry.content.begin(), entry.content.begin() + 16, std::uint8_t{0xFE});
        for (ZipEntry& other : entries)
            if (other.name == project_layout::networkNodes) other.content.pop_back();
    });
    EXPECT_THAT(loadingError(), HasSubstr("network/nodes.f64"));
}

TEST_F(ProjectFile, ALatticeWithoutItsPartsIsRefused) {
    const auto refusal = [&](const char* pointer, const auto& change) {
        changeManifestOf(filledProject(), pointer, change);
        return loadingError();
    };
    EXPECT_THAT(refusal("/arrays", [](Json& arrays) { arrays.erase(project_layout::latticeSpringShares); }),
                HasSubstr("spring-shares.f64"));
    EXPECT_THAT(refusal("/arrays", [](Json& arrays) { arrays[project_layout::latticeSpringShares] = 1; }),
                HasSubstr("spring-shares.f64"));
    EXPECT_THAT(refusal("/lattice/kind", [](Json& kind) { kind = "foam"; }), HasSubstr("lattice.kind"));
    EXPECT_THAT(refusal("/lattice/spacing", [](Json& spacing) { spacing = -1; }),
                HasSubstr("the lattice's spacing"));
    EXPECT_THAT(refusal("/arrays", [](Json& arrays) { arrays.erase(project_layout::bindingNodes); }),
                HasSubstr("nothing binds the drawn surface"));
}

TEST_F(ProjectFile, WithALatticeInAnOlderVersionOpensWithAWarning) {
    changeManifestOf(filledProject(), "/version", [](Json& version) { version = 11; });
    EXPECT_THAT(openProject(m_file).warnings, testing::Contains(HasSubstr("version should be 12")));
}

TEST_F(ProjectFile, WithAGradedLatticeIsOfVersion13) {
    Project project = filledProject();
    project =
        withDetail(project, {Detail::Kind::Filled, 0, fillingOf(*project.mesh, LatticeKind::Graded, 60)});
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
    changeManifestOf(project, "/version", [](Json& version) { version = 12; });
    EXPECT_THAT(openProject(m_file).warnings, testing::Contains(HasSubstr("version should be 13")));
}

} // namespace
} // namespace esm
