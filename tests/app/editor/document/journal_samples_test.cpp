#include "app/editor/document/journal_reader.h"
#include "core/exchange/project/project_content.h"
#include "core/exchange/project/project_file.h"
#include "tests/app/editor/document/journal_fixture.h"
#include "tests/support/samples.h"

#include <gmock/gmock.h>

using namespace esm;

/// Beside each journal lies the project as it was when the program was killed, with one step undone.
TEST(JournalSamples, AreBroughtBackAsTheyWere) {
    for (const std::filesystem::path& sample : samples("journals")) {
        if (!std::filesystem::is_directory(sample)) continue;
        SCOPED_TRACE(sample.filename());
        const TemporaryFolder folder;
        std::filesystem::copy(sample, folder / "left.journal", std::filesystem::copy_options::recursive);
        const BroughtBack back = bringBack({folder / "left.journal", {}, {}, nullptr});
        EXPECT_THAT(back.warnings, testing::IsEmpty());
        const DocumentState& state = back.state;
        ASSERT_EQ(static_cast<std::size_t>(state.index) + 1, state.steps.size());
        ASSERT_GE(state.index, 1);
        const Project& restored = *state.steps[static_cast<std::size_t>(state.index) - 1].after;
        const Project expected = loadProject(std::filesystem::path(sample).replace_extension(".esm"));
        EXPECT_EQ(contentOf(restored).manifest, contentOf(expected).manifest);
    }
}
