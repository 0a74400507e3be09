#include "core/exchange/journal/journal_replay.h"
#include "tests/support/rounds.h"

#include <gmock/gmock.h>

#include <random>

using namespace esm;

namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t many = 500;

StoredState named(const std::string& name) {
    return storedState({}, {{"name", name}}, {});
}

/// The undo list as a user of it sees it: names of the states, those done marked by the index.
std::vector<std::string> namesIn(const Replay& replay) {
    std::vector<std::string> names{replay.base.at("name")->get<std::string>()};
    for (const ReplayedStep& step : replay.steps)
        names.push_back(step.state.at("name")->get<std::string>());
    return names;
}

/// Records as a document writes them whose states have names.
class Records {
public:
    Records() { m_records.push_back(openRecord(m_written)); }

    Records& edit(std::uint64_t place, const std::string& name) {
        m_records.push_back(editRecord({place, "to " + name, std::nullopt}, m_written, named(name)));
        m_written = named(name);
        return *this;
    }
    Records& add(Json record) {
        m_records.push_back(std::move(record));
        return *this;
    }
    Replay played(std::size_t mostSteps = many) const {
        return replay(m_records, m_records.size(), mostSteps).value();
    }
    std::vector<Json>& all() { return m_records; }

private:
    StoredState m_written = named("0");
    std::vector<Json> m_records;
};

JournalFile cleanAt(std::uint64_t place) {
    JournalFile file;
    file.path = "liver.esm";
    file.clean = place;
    return file;
}

} // namespace

using testing::ElementsAre;

TEST(JournalReplay, GivesTheUndoList) {
    const Replay replay = Records().edit(1, "a").edit(2, "b").played();
    EXPECT_THAT(namesIn(replay), ElementsAre("0", "a", "b"));
    EXPECT_EQ(replay.index, 2U);
    EXPECT_EQ(replay.steps[1].text, "to b");
}

TEST(JournalReplay, LetsAnEditReplaceTheStepThatItGrows) {
    EXPECT_THAT(namesIn(Records().edit(1, "a").edit(1, "a2").edit(2, "b").played()),
                ElementsAre("0", "a2", "b"));
}

TEST(JournalReplay, DropsWhatCannotBeRedoneAnyMore) {
    const Replay replay = Records().edit(1, "a").edit(2, "b").add(moveRecord(1, 2)).edit(2, "c").played();
    EXPECT_THAT(namesIn(replay), ElementsAre("0", "a", "c"));
    const Replay undone = Records().edit(1, "a").edit(2, "b").add(moveRecord(1, 2)).played();
    EXPECT_EQ(undone.index, 1U);
    EXPECT_THAT(namesIn(undone), ElementsAre("0", "a", "b"));
    const Replay nothingLeft = Records().edit(1, "a").edit(2, "b").add(moveRecord(1, 1)).played();
    EXPECT_THAT(namesIn(nothingLeft), ElementsAre("0", "a"));
}

TEST(JournalReplay, ForgetsTheFirstStepsOfALongList) {
    Records records;
    for (int i = 1; i <= 5; ++i)
        records.edit(static_cast<std::uint64_t>(i), std::to_string(i));
    const Replay replay = records.add(moveRecord(4, 5)).played(3);
    EXPECT_THAT(namesIn(replay), ElementsAre("2", "3", "4", "5"));
    EXPECT_EQ(replay.index, 2U);
}

TEST(JournalReplay, KnowsWhatLiesInTheFile) {
    Records records;
    records.edit(1, "a").add(fileRecord(cleanAt(1)));
    EXPECT_FALSE(records.played().isUnsaved());
    EXPECT_EQ(records.played().file.path, "liver.esm");
    records.edit(2, "b");
    EXPECT_TRUE(records.played().isUnsaved());
    records.add(moveRecord(1, 2));
    EXPECT_FALSE(records.played().isUnsaved()) << "undone to what was saved";
    records.add(moveRecord(0, 2)).edit(1, "c");
    EXPECT_TRUE(records.played().isUnsaved());
    EXPECT_EQ(records.played().clean, std::nullopt) << "what was saved cannot be reached any more";
}

TEST(JournalReplay, ForgetsWhatWasSavedWithTheFirstSteps) {
    Records records;
    records.add(fileRecord(cleanAt(0)));
    for (int i = 1; i <= 4; ++i)
        records.edit(static_cast<std::uint64_t>(i), std::to_string(i));
    EXPECT_EQ(records.played(4).clean, 0U);
    EXPECT_EQ(records.played(3).clean, std::nullopt);
}

TEST(JournalReplay, EndsBeforeARecordThatMakesNoSense) {
    const std::vector<Json> senseless{Json::array(),
                                      {{"record", "unknown"}},
                                      openRecord(named("x")),
                                      moveRecord(9, 9),
                                      moveRecord(1, 0),
                                      {{"record", "edit"}, {"place", 1}},
                                      editRecord({5, "far away", std::nullopt}, named("a"), named("x")),
                                      {{"record", "view"}, {"workspace", 3}},
                                      {{"record", "file"}, {"path", "p"}}};
    for (const Json& record : senseless) {
        SCOPED_TRACE(record.dump());
        Records records;
        const Replay replay = records.edit(1, "a").add(record).edit(2, "b").played();
        EXPECT_THAT(namesIn(replay), ElementsAre("0", "a"));
        EXPECT_EQ(replay.taken, 2U);
    }
}

TEST(JournalReplay, IsNothingWithoutABeginning) {
    EXPECT_FALSE(replay({}, 0, many));
    EXPECT_FALSE(replay({moveRecord(0, 0)}, 1, many));
}

namespace {

/// Puts something else in a place of a record that is chosen at random.
void spoil(Json& json, std::mt19937& random) {
    const auto below = [&](std::size_t size) { return random() % size; };
    if (json.is_structured() && !json.empty() && below(4) != 0) {
        auto at = json.begin();
        std::advance(at, static_cast<std::ptrdiff_t>(below(json.size())));
        return spoil(*at, random);
    }
    const std::vector<Json> others{nullptr,
                                   -1,
                                   0,
                                   1,
                                   1e300,
                                   true,
                                   "",
                                   "text",
                                   Json::array(),
                                   Json::object(),
                                   std::numeric_limits<std::uint64_t>::max()};
    json = others[below(others.size())];
}

} // namespace

TEST(JournalReplay, SurvivesRecordsOfAnyKind) {
    for (int round = 0; round < roundsOf(300, 20000); ++round) {
        SCOPED_TRACE(seedOf(round));
        std::mt19937 random(seedOf(round));
        Records records;
        records.edit(1, "a").edit(2, "b").add(moveRecord(1, 2)).add(fileRecord(cleanAt(1)));
        records.add(viewRecord({"tissue", RegionId{1}, LayerId{2}})).edit(2, "c");
        for (int times = 0; times < 3; ++times)
            spoil(records.all()[random() % records.all().size()], random);
        const auto played = replay(records.all(), records.all().size(), 2);
        if (!played) continue;
        ASSERT_LE(played->index, played->steps.size());
        ASSERT_LE(played->steps.size(), 2U);
        if (played->clean) {
            ASSERT_LE(*played->clean, played->steps.size());
        }
    }
}
