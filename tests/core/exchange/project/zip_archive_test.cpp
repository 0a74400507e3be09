#include "core/exchange/project/zip_archive.h"

#include "core/support/errors.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace esm {
namespace {

using testing::HasSubstr;

std::vector<ZipEntry> someEntries() {
    return {{"a.txt", {'a'}, true},
            {"folder/zeros", Bytes(100000, 0), true},
            {"empty", {}, false},
            {"b.png", {0x89, 'P', 'N', 'G'}, false}};
}

std::string readError(const Bytes& archive, const std::string& entry, std::uint64_t largest = 1 << 20) {
    try {
        static_cast<void>(ZipReader(archive).read(entry, largest));
    } catch (const InvalidModel& error) {
        return error.what();
    }
    return "read";
}

TEST(ZipArchive, GivesBackEveryEntry) {
    const Bytes archive = makeZip(someEntries());
    EXPECT_LT(archive.size(), 2000U);
    const ZipReader reader(archive);
    for (const ZipEntry& entry : someEntries())
        EXPECT_EQ(reader.read(entry.name, entry.content.size()), entry.content) << entry.name;
}

TEST(ZipArchive, TheSameEntriesGiveTheSameBytes) {
    EXPECT_EQ(makeZip(someEntries()), makeZip(someEntries()));
}

TEST(ZipArchive, UnpacksNoMoreThanItIsTold) {
    const Bytes archive = makeZip(someEntries());
    EXPECT_THAT(readError(archive, "folder/zeros", 99999),
                HasSubstr("folder/zeros is larger than the 99999"));
    EXPECT_EQ(readError(archive, "folder/zeros", 100000), "read");
    EXPECT_THAT(readError(archive, "none"), HasSubstr("none is missing"));
}

TEST(ZipArchive, FindsDamageAnywhere) {
    const Bytes whole = makeZip(someEntries());
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(readError(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)), "a.txt"),
                  "read")
            << size;
    Bytes damaged = whole;
    *std::find(damaged.begin(), damaged.end(), 0x89) ^= 1; // where the stored picture begins
    EXPECT_NE(readError(damaged, "b.png"), "read");
}

} // namespace
} // namespace esm
