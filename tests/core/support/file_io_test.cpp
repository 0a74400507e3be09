#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sys/stat.h>

using namespace esm;

TEST(FileIo, ReadsBackWhatItWrote) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("first"));
    writeFileAtomically(folder / "a", Bytes{1, 2, 0, 3});
    EXPECT_EQ(readFile(folder / "a"), (Bytes{1, 2, 0, 3}));
}

TEST(FileIo, KeepsPermissionsAndLinks) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", std::string("x"));
    ::chmod((folder / "a").c_str(), 0640);
    std::filesystem::create_symlink("a", folder / "link");
    writeFileAtomically(folder / "link", std::string("y"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(readFile(folder / "a"), Bytes{'y'});
    struct stat status {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(FileIo, LeavesTheOldFileWhenTheNewCannotBeWritten) {
    const TemporaryFolder folder;
    EXPECT_THROW(writeFileAtomically(folder / "missing" / "a", std::string("x")), FileError);
    std::filesystem::create_directory(folder / "sub");
    EXPECT_THROW(writeFileAtomically(folder / "sub", std::string("x")), FileError);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().filename(), "sub");
}

TEST(FileIo, NamesTheFileItCannotRead) {
    const TemporaryFolder folder;
    try {
        readFile(folder / "none.obj");
        FAIL() << "a missing file was read";
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find("none.obj"), std::string::npos);
    }
    EXPECT_THROW(readFile(folder.path()), FileError);
}
