#include "core/exchange/journal/journal_records.h"

#include "core/exchange/project/project_content.h"
#include "core/support/errors.h"
#include "core/support/json_reader.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

// Members of a state beside those of its manifest.
constexpr const char* blobsMember = "blobs";
constexpr const char* regionsMember = "regionNumbers";
constexpr const char* layersMember = "layerNumbers";

constexpr std::size_t sumDigits = 8;

template<typename Part> Json numbersOf(const std::vector<Part>& parts) {
    Json numbers = Json::array();
    for (const Part& part : parts)
        numbers.push_back(part.id.number);
    return numbers;
}

/// What `take` makes of a member. @throws InvalidModel with all that is wrong with it
template<typename Take> auto taken(const StoredState& state, const char* member, const Take& take) {
    const auto found = state.find(member);
    if (found == state.end()) throw InvalidModel("the record lacks " + std::string(member));
    std::vector<std::string> problems;
    auto value = take(JsonReader(*found->second, member, problems));
    if (!problems.empty()) throw InvalidModel(problems);
    return value;
}

template<typename Part> void number(std::vector<Part>& parts, const StoredState& state, const char* member) {
    const std::vector<std::uint32_t> numbers = taken(state, member, [](const JsonReader& reader) {
        std::vector<std::uint32_t> read;
        for (const JsonReader& element : reader.elements())
            read.push_back(static_cast<std::uint32_t>(element.integer(1, UINT32_MAX)));
        return read;
    });
    if (numbers.size() != parts.size() ||
        std::set<std::uint32_t>(numbers.begin(), numbers.end()).size() != numbers.size())
        throw InvalidModel(std::string(member) + " do not tell the parts apart");
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].id = {numbers[i]};
}

std::string checkSum(std::string_view json) {
    const uLong sum = crc32_z(0, reinterpret_cast<const Bytef*>(json.data()), json.size());
    std::string digits(sumDigits, '0');
    for (std::size_t i = 0; i < sumDigits; ++i)
        digits[i] = "0123456789abcdef"[sum >> (4 * (sumDigits - 1 - i)) & 15];
    return digits;
}

/// None where it is damaged.
std::optional<Json> recordIn(std::string_view line) {
    if (line.size() < sumDigits + 1 || line[sumDigits] != ' ') return std::nullopt;
    const std::string_view json = line.substr(sumDigits + 1);
    if (line.substr(0, sumDigits) != checkSum(json)) return std::nullopt;
    try {
        return parseJson(json.data(), json.data() + json.size());
    } catch (const InvalidModel&) {
        return std::nullopt;
    }
}

} // namespace

StoredState storedState(const Project& project, const Json& manifest, const EntryBlobs& blobs) {
    StoredState state;
    for (const auto& [key, value] : manifest.items())
        state[key] = std::make_shared<const Json>(value);
    state[blobsMember] = std::make_shared<const Json>(blobs);
    state[regionsMember] = std::make_shared<const Json>(numbersOf(project.regions));
    state[layersMember] = std::make_shared<const Json>(numbersOf(project.layers));
    return state;
}

Json manifestOf(const StoredState& state) {
    Json manifest = Json::object();
    for (const auto& [key, value] : state)
        if (key != blobsMember && key != regionsMember && key != layersMember) manifest[key] = *value;
    return manifest;
}

EntryBlobs blobsOf(const StoredState& state) {
    return taken(state, blobsMember, [](const JsonReader& reader) {
        EntryBlobs blobs;
        for (const auto& [entry, names] : reader.members())
            blobs[entry] = names.texts();
        return blobs;
    });
}

void giveIdentities(Project& project, const StoredState& state) {
    number(project.regions, state, regionsMember);
    number(project.layers, state, layersMember);
}

Json changeOf(const StoredState& before, const StoredState& after) {
    Json members = Json::object(), gone = Json::array();
    for (const auto& [key, value] : after) {
        const auto former = before.find(key);
        if (former == before.end() || *former->second != *value) members[key] = *value;
    }
    for (const auto& member : before)
        if (!after.contains(member.first)) gone.push_back(member.first);
    return {{"members", std::move(members)}, {"gone", std::move(gone)}};
}

Json openRecord(const StoredState& state, std::uint64_t place) {
    return {{"record", "open"}, {"version", 1}, {"place", place}, {"change", changeOf({}, state)}};
}

Json editRecord(const JournalStep& step, const StoredState& before, const StoredState& after) {
    Json json{{"record", "edit"}, {"place", step.place}, {"text", step.text}};
    if (step.systemOf) json["systemOf"] = step.systemOf->number;
    json["change"] = changeOf(before, after);
    return json;
}

Json moveRecord(std::uint64_t place, std::uint64_t last) {
    return {{"record", "move"}, {"place", place}, {"last", last}};
}

Json fileRecord(const JournalFile& file) {
    Json json{{"record", "file"},
              {"path", file.path},
              {"formerTitle", file.formerTitle},
              {"formerPath", file.formerPath},
              {"version", file.version}};
    if (file.clean) json["clean"] = *file.clean;
    return json;
}

Json viewRecord(const JournalView& view) {
    Json json{{"record", "view"}, {"workspace", view.workspace}};
    if (view.region) json["region"] = view.region->number;
    if (view.photo) json["photo"] = view.photo->number;
    return json;
}

std::string recordLine(const Json& record) {
    const std::string json = manifestText(record);
    guardJson(json.data(), json.data() + json.size());
    return checkSum(json) + ' ' + json + '\n';
}

JournalRecords recordsIn(std::string_view text, const Progress& progress) {
    const auto all = static_cast<double>(text.size());
    JournalRecords found;
    while (!text.empty()) {
        reportProgress(progress, 1 - static_cast<double>(text.size()) / all);
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return found;
        std::optional<Json> record = recordIn(text.substr(0, end));
        found.areWhole = record.has_value();
        if (!record) return found;
        found.records.push_back(std::move(*record));
        text.remove_prefix(end + 1);
    }
    return found;
}

} // namespace esm
