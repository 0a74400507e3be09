#pragma once

#include "core/support/file_io.h"
#include "tests/support/steady_progress.h"
#include "tests/support/temporary_folder.h"

namespace esm {

/// A folder with one file that work would replace.
class KeptFile : public testing::Test {
protected:
    void SetUp() override { writeFileAtomically(file, before); }

    bool isUntouched() const {
        const std::filesystem::directory_iterator all(folder.path());
        return std::distance(all, {}) == 1 && readFile(file) == before;
    }
    void expectGoodWriting(const test::LongWork& write) const {
        test::expectStopsAnywhere(write, [this] { return isUntouched(); });
        test::expectSteadyProgress(write);
        EXPECT_FALSE(isUntouched());
    }

    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "before";
    const Bytes before{1, 2, 3};
};

} // namespace esm
