#include "tests/core/exchange/project/project_file_fixture.h"

#include "tests/support/same_project.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

TEST_F(ProjectFile, KeepsHowASheetSharesItsTissueOut) {
    const Project project = sheetProject();
    ASSERT_TRUE(project.network->sheet);
    saveProject(project, m_file);
    expectSameProject(project, loadProject(m_file));
}

TEST_F(ProjectFile, SharesOfASheetThatAreNoneAreRefused) {
    const auto refusal = [&](const char* array, std::uint8_t lastByte) {
        saveChangedOf(sheetProject(), array,
                      [&](auto&, ZipEntry& entry) { entry.content[7] = lastByte; }); // of the first number
        return loadingError();
    };
    EXPECT_THAT(refusal(project_layout::sheetSpringShares, 0xBF),
                HasSubstr("1 spring whose share of the sheet is not above 0, or beyond 1000 (spring 0)"));
    EXPECT_THAT(refusal(project_layout::sheetNodeShares, 0x4F),
                HasSubstr("1 node whose share of the sheet is not above 0, or beyond 1000 (node 0)"));
}

TEST_F(ProjectFile, ASheetWithoutAllItsSharesIsRefused) {
    const auto refusal = [&](const auto& change) {
        changeManifestOf(sheetProject(), "/arrays", change);
        return loadingError();
    };
    EXPECT_THAT(refusal([](Json& arrays) { arrays.erase(project_layout::sheetNodeShares); }),
                HasSubstr("node-shares.f64"));
    EXPECT_THAT(refusal([](Json& arrays) { arrays[project_layout::sheetSpringShares] = 1; }),
                HasSubstr("spring-shares.f64"));
}

TEST_F(ProjectFile, WithASheetInAnOlderVersionOpensWithAWarning) {
    changeManifestOf(sheetProject(), "/version", [](Json& version) { version = 12; });
    EXPECT_THAT(openProject(m_file).warnings, testing::Contains(HasSubstr("version should be 13")));
}

} // namespace
} // namespace esm
