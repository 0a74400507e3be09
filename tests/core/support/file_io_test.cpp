#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/full_disk.h"
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
    writeFileAtomically(folder / "a", std::string("old"));
    EXPECT_TRUE(throwsOnFullDisk<FileError>(
        100'000, [&] { writeFileAtomically(folder / "a", std::string(1'000'000, 'n')); }));
    EXPECT_EQ(readFile(folder / "a"), (Bytes{'o', 'l', 'd'}));
    ASSERT_EQ(::chmod((folder / "a").c_str(), 0444), 0);
    EXPECT_THROW(writeFileAtomically(folder / "a", std::string("new")), FileError);
    EXPECT_EQ(readFile(folder / "a"), (Bytes{'o', 'l', 'd'}));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().filename(), "a");
}

TEST(FileIo, LeavesNothingWhereItCannotWrite) {
    const TemporaryFolder folder;
    EXPECT_THROW(writeFileAtomically(folder / "missing" / "a", std::string("x")), FileError);
    std::filesystem::create_directory(folder / "sub");
    EXPECT_THROW(writeFileAtomically(folder / "sub", std::string("x")), FileError);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().filename(), "sub");
}

TEST(FileIo, SaysWhenAFolderMayNotBeSearched) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "locked");
    writeFileAtomically(folder / "locked" / "a", std::string("x"));
    ASSERT_EQ(::chmod((folder / "locked").c_str(), 0), 0);
    // The superuser may search everything.
    const bool isSuperuser = ::geteuid() == 0;
    ASSERT_EQ(isSuperuser ? ::seteuid(65534) : 0, 0);
    std::string read, written;
    try {
        readFile(folder / "locked" / "a");
    } catch (const FileError& error) {
        read = error.what();
    }
    try {
        writeFileAtomically(folder / "locked" / "a", std::string("y"));
    } catch (const FileError& error) {
        written = error.what();
    }
    ASSERT_EQ(isSuperuser ? ::seteuid(0) : 0, 0);
    ::chmod((folder / "locked").c_str(), 0700);
    EXPECT_NE(read.find("cannot be reached"), std::string::npos) << read;
    EXPECT_NE(written.find("cannot be reached"), std::string::npos) << written;
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
