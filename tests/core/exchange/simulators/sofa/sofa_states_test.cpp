#include "core/exchange/simulators/sofa/sofa_states.h"

#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class SofaStates : public testing::Test {
protected:
    std::vector<SofaState> read(const std::string& text, std::size_t nodes = 2, std::size_t most = 10) {
        writeFileAtomically(m_file, text);
        return readSofaStates(m_file, nodes, most);
    }
    std::string errorOf(const std::string& text) {
        try {
            read(text);
        } catch (const InvalidModel& error) {
            return error.what();
        }
        return "no error";
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "states.txt";
};

TEST_F(SofaStates, HaveTheirTimeAndEveryNode) {
    const auto states =
        read("T= 0\n  X= 0 0 0 1 2 3 \n  V= 9 9 9 9 9 9\nT= 0.025\n  X= 1e-3 -2 0.5 1 2 3.5\n");
    ASSERT_EQ(states.size(), 2U);
    EXPECT_EQ(states[0].time, 0);
    EXPECT_EQ(states[1].time, 0.025);
    EXPECT_EQ(states[1].positions.at(0), Eigen::Vector3d(1e-3, -2, 0.5));
    EXPECT_EQ(states[1].positions.at(1), Eigen::Vector3d(1, 2, 3.5));
}

TEST_F(SofaStates, EndBeforeALineThatWasCutShort) {
    EXPECT_EQ(read("T= 0\nX= 0 0 0 1 2 3\nT= 0.1\nX= 0 0 0 1 2").size(), 1U);
    EXPECT_EQ(read("").size(), 0U);
    EXPECT_EQ(read("T= 0").size(), 0U);
}

TEST_F(SofaStates, AreRefusedWhereTheMotionBlewUp) {
    for (const char* number : {"nan", "-nan", "inf", "-inf", "1e999"})
        EXPECT_THAT(errorOf("T= 0.5\nX= 0 0 0 1 " + std::string(number) + " 3\n"),
                    AllOf(HasSubstr("at 0.5 s"), HasSubstr("blew up"), HasSubstr("shorter time step")));
    EXPECT_THAT(errorOf("T= nan\nX= 0 0 0 1 2 3\n"), HasSubstr("blew up"));
}

TEST_F(SofaStates, AreRefusedWhereTheyAreOfAnotherOrgan) {
    EXPECT_THAT(errorOf("T= 0\nX= 0 0 0\n"), AllOf(HasSubstr("line 2"), HasSubstr("1 nodes where 2")));
    EXPECT_THAT(errorOf("T= 0\nX= 0 0 0 1 2 3 4 5 6\n"), HasSubstr("3 nodes where 2"));
    EXPECT_THAT(errorOf("T= 0\nX= 0 0 0 1 2\n"), HasSubstr("for a number"));
    EXPECT_THAT(errorOf("T= 0\nX= 0 0 0 1 2 none\n"), HasSubstr("\"none\""));
    EXPECT_THAT(errorOf("X= 0 0 0 1 2 3\n"), HasSubstr("without a time"));
}

TEST_F(SofaStates, AreNotReadFromAFileThatIsFarTooLarge) {
    EXPECT_THROW(read("T= 0\nX= 0 0 0 1 2 3\n" + std::string(100'000, ' '), 2, 1), FileError);
    EXPECT_THROW(readSofaStates(m_folder / "none", 2, 1), FileError);
}

} // namespace
} // namespace esm
