#include "core/support/appended_file.h"
#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

using namespace esm;

TEST(AppendedFile, GrowsAtItsEnd) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "log", std::string("one "));
    for (const char* text : {"two ", "three"}) {
        AppendedFile file(folder / "log");
        file.append(text);
        file.sync();
    }
    const Bytes content = readFile(folder / "log");
    EXPECT_EQ(std::string(content.begin(), content.end()), "one two three");
}

TEST(AppendedFile, TellsWhatCannotBeWritten) {
    const TemporaryFolder folder;
    EXPECT_THROW(AppendedFile(folder / "missing"), FileError);
    EXPECT_THROW(syncFolder(folder / "missing"), FileError);
    EXPECT_NO_THROW(syncFolder(folder.path()));
    writeFileAtomically(folder / "log", std::string(100, ' '));
    EXPECT_TRUE(throwsOnFullDisk<FileError>(
        150, [&] { AppendedFile(folder / "log").append(std::string(100, ' ')); }));
}
