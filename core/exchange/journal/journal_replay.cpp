#include "core/exchange/journal/journal_replay.h"

#include "core/support/errors.h"
#include "core/support/json_reader.h"

#include <algorithm>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::uint64_t farthestPlace = std::uint64_t{1} << 48;

template<typename Part> std::optional<Id<Part>> identity(const JsonReader& reader, const char* key) {
    if (!reader.has(key)) return std::nullopt;
    return Id<Part>{static_cast<std::uint32_t>(reader.member(key).integer(1, UINT32_MAX))};
}

std::optional<std::uint64_t> placeIn(const JsonReader& reader, const char* key) {
    if (!reader.has(key)) return std::nullopt;
    return reader.member(key).integer(0, farthestPlace);
}

/// The undo list while records are taken in.
class Player {
public:
    explicit Player(std::size_t mostSteps) : m_mostSteps(mostSteps) {}

    /// False for a record that makes no sense here; the list is then as it was.
    bool take(const Json& json) {
        std::vector<std::string> problems;
        const JsonReader record(json, "", problems);
        const std::string kind = record.member("record").text();
        if (m_isOpen == (kind == "open")) return false;
        if (kind == "open") return open(record, problems);
        if (kind == "edit") return edit(record, problems);
        if (kind == "move") return move(record, problems);
        if (kind == "file") return takeFile(record, problems);
        return kind == "view" && takeView(record, problems);
    }

    const StoredState& now() const { return m_replay.now(); }

    std::optional<Replay> result() && {
        if (!m_isOpen) return std::nullopt;
        if (m_clean && *m_clean >= m_first && *m_clean <= last()) m_replay.clean = *m_clean - m_first;
        return std::move(m_replay);
    }

private:
    std::uint64_t last() const { return m_first + m_replay.steps.size(); }

    /// The state after the latest record with one.
    StoredState changed(const JsonReader& record) const {
        StoredState state = m_written;
        const JsonReader change = record.member("change");
        for (const auto& [key, value] : change.member("members").members())
            state[key] = std::make_shared<const Json>(value.json());
        for (const std::string& key : change.member("gone").texts())
            state.erase(key);
        return state;
    }

    bool open(const JsonReader& record, const std::vector<std::string>& problems) {
        record.member("version").integer(1, 1);
        m_first = placeIn(record, "place").value_or(0);
        m_written = changed(record);
        m_replay.base = m_written;
        m_isOpen = problems.empty();
        return m_isOpen;
    }

    bool edit(const JsonReader& record, const std::vector<std::string>& problems) {
        ReplayedStep step{record.member("text").text(), identity<Region>(record, "systemOf"),
                          changed(record)};
        const std::uint64_t place = record.member("place").integer(m_first + 1, farthestPlace);
        if (!problems.empty() || place > m_first + m_replay.index + 1) return false;
        m_written = step.state;
        m_replay.steps.resize(place - m_first - 1);
        m_replay.steps.push_back(std::move(step));
        if (m_clean && *m_clean >= place) m_clean.reset();
        if (m_replay.steps.size() > m_mostSteps) dropFirst();
        m_replay.index = m_replay.steps.size();
        return true;
    }

    void dropFirst() {
        m_replay.base = std::move(m_replay.steps.front().state);
        m_replay.steps.erase(m_replay.steps.begin());
        ++m_first;
    }

    bool move(const JsonReader& record, const std::vector<std::string>& problems) {
        const std::uint64_t place = record.member("place").integer(m_first, last());
        const std::uint64_t end = record.member("last").integer(m_first, last());
        if (!problems.empty() || place > end) return false;
        m_replay.index = place - m_first;
        m_replay.steps.resize(end - m_first);
        if (m_clean && *m_clean > end) m_clean.reset();
        return true;
    }

    bool takeFile(const JsonReader& record, const std::vector<std::string>& problems) {
        JournalFile file{record.member("path").text(),
                         record.member("formerTitle").text(),
                         record.member("formerPath").text(),
                         {},
                         placeIn(record, "clean")};
        for (const JsonReader& number : record.member("version").elements())
            file.version.push_back(number.json().is_number_integer() ? number.json().get<std::int64_t>()
                                                                     : -1);
        if (!problems.empty()) return false;
        m_clean = file.clean;
        m_replay.file = std::move(file);
        return true;
    }

    bool takeView(const JsonReader& record, const std::vector<std::string>& problems) {
        JournalView view{record.member("workspace").text(), identity<Region>(record, "region"),
                         identity<TextureLayer>(record, "photo")};
        if (!problems.empty()) return false;
        m_replay.view = std::move(view);
        return true;
    }

    std::size_t m_mostSteps;
    bool m_isOpen = false;
    std::uint64_t m_first = 0; ///< place of the base
    std::optional<std::uint64_t> m_clean;
    StoredState m_written;
    Replay m_replay;
};

} // namespace

std::optional<Replay> replay(const std::vector<Json>& records, std::size_t count, std::size_t mostSteps) {
    Player player(mostSteps);
    std::size_t taken = 0;
    while (taken < std::min(count, records.size()) && player.take(records[taken]))
        ++taken;
    std::optional<Replay> replay = std::move(player).result();
    if (replay) replay->taken = taken;
    return replay;
}

std::vector<StoredState> statesAfter(const std::vector<Json>& records, std::size_t mostSteps) {
    Player player(mostSteps);
    std::vector<StoredState> states;
    for (const Json& record : records) {
        if (!player.take(record)) break;
        states.push_back(player.now());
    }
    return states;
}

} // namespace esm
