#include "app/editor/document/journal.h"
#include "tests/app/editor/document/random_edits.h"
#include "tests/app/editor/document/steady_time.h"
#include "tests/support/eventually.h"
#include "tests/support/rounds.h"
#include "tests/support/temporary_folder.h"

#include <QProcess>

#include <map>
#include <sstream>

using namespace esm;

namespace {

constexpr std::int64_t millisecond = 1'000'000, second = 1'000'000'000; // ns

/// What a program told until it was killed.
struct Told {
    struct State {
        std::int64_t committed = 0; // ns
        std::string digest;
        std::uint64_t task = 0; ///< 0 where it was killed before it told
    };
    std::map<int, State> states;
    std::uint64_t synced = 0; ///< the last task that is on the disk
    struct Span {
        std::int64_t begin, end; // ns
    };
    std::vector<Span> writing;       ///< when the writer was at work
    std::vector<std::int64_t> ticks; ///< ns, when the machine let the program run
    std::int64_t killed = 0;         // ns

    void take(const std::string& line);
    /// Of the time since `begin`, how much the disk took, and how much the machine gave to others.
    std::int64_t heldUp(std::int64_t begin) const;
    int lastWith(const std::string& digest) const;
};

void Told::take(const std::string& line) {
    std::istringstream in(line);
    char kind = 0;
    in >> kind;
    int number = 0;
    std::uint64_t task = 0;
    std::int64_t time = 0;
    if (kind == 'C') {
        State state;
        in >> number >> state.committed >> state.digest;
        if (state.digest.size() == 64) states[number] = state;
    } else if (kind == 'P' && in >> number >> task) {
        states[number].task = task;
    } else if (kind == 'B' && in >> task >> time) {
        writing.push_back({time, std::numeric_limits<std::int64_t>::max()});
    } else if (kind == 'S' && in >> task >> time) {
        synced = task;
        writing.back().end = time;
    } else if (kind == 'T' && in >> time) {
        ticks.push_back(time);
    }
}

std::int64_t Told::heldUp(std::int64_t begin) const {
    std::int64_t sum = 0;
    for (const Span& span : writing)
        sum += std::max<std::int64_t>(0, std::min(span.end, killed) - std::max(span.begin, begin));
    // A tick that comes late is time that the machine gave to others.
    std::int64_t before = begin;
    const auto lateness = [&](std::int64_t now) {
        return std::max<std::int64_t>(0, now - before - 25 * millisecond);
    };
    for (const std::int64_t tick : ticks) {
        if (tick <= begin) continue;
        sum += lateness(tick);
        before = tick;
    }
    return sum + lateness(killed);
}

int Told::lastWith(const std::string& digest) const {
    for (auto state = states.rbegin(); state != states.rend(); ++state)
        if (state->second.digest == digest) return state->first;
    return -1;
}

/// Lets a program edit until it has told `lines` lines, and kills it a little later.
Told toldUntilKilled(const std::filesystem::path& folder, std::uint32_t seed, int lines,
                     unsigned microseconds) {
    QProcess victim;
    victim.start(QCoreApplication::applicationDirPath() + "/journal_victim",
                 {QString::fromStdString(folder.string()), QString::number(seed)});
    Told told;
    const auto takeLines = [&] {
        while (victim.canReadLine()) {
            told.take(victim.readLine().toStdString());
            --lines;
        }
    };
    while (lines > 0 && victim.waitForReadyRead(patience))
        takeLines();
    EXPECT_LE(lines, 0) << victim.errorString().toStdString();
    ::usleep(microseconds);
    told.killed = steadyTime();
    victim.kill();
    victim.waitForFinished(patience);
    takeLines();
    return told;
}

/// What the undo list leads through, step by step, worked out from what the document becomes.
DocumentState walked(Document& document) {
    DocumentState state = document.state();
    QUndoStack& stack = *document.undoStack();
    const int index = stack.index();
    for (int place = 0; place <= stack.count(); ++place) {
        stack.setIndex(place);
        const auto now = std::make_shared<const Project>(document.project());
        (place == 0 ? state.base : state.steps[static_cast<std::size_t>(place) - 1].after) = now;
    }
    stack.setIndex(index);
    return state;
}

void expectNothingOldIsLost(const Told& told, int recovered) {
    for (const auto& [number, state] : told.states) {
        const bool isSynced = state.task != 0 && state.task <= told.synced;
        EXPECT_FALSE(isSynced && number > recovered) << "state " << number << " was on the disk";
    }
    const auto lost = told.states.upper_bound(recovered);
    if (lost == told.states.end()) return;
    const std::int64_t committed = lost->second.committed, age = told.killed - committed;
    EXPECT_LE(age, second + told.heldUp(committed))
        << "state " << lost->first << " was lost; in ms it was " << age / millisecond << " old, and "
        << told.heldUp(committed) / millisecond << " of that went to the disk and to other programs";
}

} // namespace

TEST(JournalKill, LosesNothingOlderThanASecond) {
    int recoveredRounds = 0;
    for (int round = 0; round < roundsOf(20, 200); ++round) {
        const std::uint32_t seed = seedOf(round);
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const TemporaryFolder folder;
        const Told told = toldUntilKilled(folder.path(), seed, 10 + static_cast<int>(random() % 500),
                                          static_cast<unsigned>(random() % 30000));
        auto left = leftBehindIn(folder.path());
        if (left.empty()) {
            expectNothingOldIsLost(told, -1);
            continue;
        }
        ASSERT_EQ(left.size(), 1U);
        ++recoveredRounds;
        for (int times = 0; times < 2; ++times) {
            const BroughtBack back = bringBack(left.front());
            EXPECT_TRUE(back.warnings.empty()) << back.warnings.front();
            Document document(projectToEdit());
            document.restore(back.state);
            DocumentDigests digests;
            const int recovered = told.lastWith(digests.of(walked(document)));
            ASSERT_GE(recovered, 0) << "what came back was never committed";
            expectNothingOldIsLost(told, recovered);
        }
    }
    EXPECT_GT(recoveredRounds, roundsOf(20, 200) / 2) << "most are killed with work to lose";
}
