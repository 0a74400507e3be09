#include "core/exchange/project/pairs_file.h"

#include "core/support/errors.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace esm;
using testing::HasSubstr;

namespace {

class PairsFile : public testing::Test {
protected:
    std::vector<LandmarkPair> read(const std::string& text) {
        std::ofstream(m_folder / "pairs.csv", std::ios::binary) << text;
        return readPairsFile(m_folder / "pairs.csv");
    }
    std::string refusal(const std::string& text) {
        try {
            read(text);
        } catch (const FileError& error) {
            return error.what();
        }
        return "accepted";
    }

    TemporaryFolder m_folder;
};

const std::string header = "photo_x,photo_y,x,y,z\n";

} // namespace

TEST_F(PairsFile, ReadsPixelsAndMetres) {
    for (const std::string& text :
         {header + "1,2.5,-0.1,1e-3,+4\n", header + " 1 , 2.5,-0.1 ,0.001,4\r\n\n",
          std::string("\xEF\xBB\xBFphoto_x, photo_y, x, y, z\r\n1,2.5,-0.1,.001,4")}) {
        const std::vector<LandmarkPair> pairs = read(text);
        ASSERT_EQ(pairs.size(), 1U) << text;
        EXPECT_EQ(pairs[0].photo, Eigen::Vector2d(1, 2.5));
        EXPECT_EQ(pairs[0].organ, Eigen::Vector3d(-0.1, 0.001, 4));
    }
    EXPECT_TRUE(read(header).empty());
}

TEST_F(PairsFile, NamesTheLineThatIsNoPair) {
    for (const char* line : {"1,2,3,4", "1,2,3,4,5,6", "1,2,3,4,", "1,2,3,4,five", "1,2,3,4,nan",
                             "1,2,3,4,1e999", "1;2;3;4;5", ",,,,", "1 1,2,3,4,5"})
        EXPECT_THAT(
            refusal(header + "1,2,3,4,5\n\n" + line + "\n6,7,8,9,10\n"),
            testing::AllOf(HasSubstr("pairs.csv: line 4 is no pair"), HasSubstr("photo_x,photo_y,x,y,z")))
            << line;
}

TEST_F(PairsFile, AsksForTheColumnsNames) {
    for (const char* text : {"", "1,2,3,4,5\n", "x,y,z\n"})
        EXPECT_NE(refusal(text), "accepted") << text;
    EXPECT_THAT(refusal("1,2,3,4,5\n"), HasSubstr("line 1 should be photo_x,photo_y,x,y,z"));
    EXPECT_THAT(refusal(header + std::string("1,2,\0,4,5\n", 10)), HasSubstr("is not CSV text"));
}

TEST_F(PairsFile, ReadsWhatWasWritten) {
    const std::vector<LandmarkPair> pairs{{{1.0 / 3, 2e-9}, {-0.1, 1e-3, 4e20}}, {{0, -5}, {1, 2, 3}}};
    writePairsFile(pairs, m_folder / "written.csv");
    EXPECT_EQ(readPairsFile(m_folder / "written.csv"), pairs);
    EXPECT_THROW(writePairsFile(pairs, m_folder / "missing" / "written.csv"), FileError);
}
