#include "core/support/json_reader.h"

#include "core/support/errors.h"
#include "core/support/file_io.h"
#include "core/support/joined.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace esm {

using Json = nlohmann::ordered_json;

namespace {

std::string lineAndColumn(const char* begin, const char* end, std::size_t byte) {
    const char* place = begin + std::min(byte > 0 ? byte - 1 : 0, static_cast<std::size_t>(end - begin));
    const char* lineStart = place;
    while (lineStart != begin && lineStart[-1] != '\n')
        --lineStart;
    return "line " + std::to_string(std::count(begin, place, '\n') + 1) + ", column " +
           std::to_string(place - lineStart + 1);
}

/// Goes through a document before it is built. The parser itself would keep one of two equal keys without a
/// word, compares each key with all before it, and nests without end; watching it by its callback makes it
/// slow for long lists.
class ParseGuard : public nlohmann::json_sax<Json> {
public:
    ParseGuard(const char* begin, const char* end) : m_begin(begin), m_end(end) {}

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }

    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }
    bool start_object(std::size_t) override {
        m_open.emplace_back();
        return enter();
    }
    bool end_object() override {
        m_open.pop_back();
        return leave();
    }
    bool key(string_t& key) override;

    bool parse_error(std::size_t byte, const std::string&,
                     const nlohmann::detail::exception& error) override {
        if (dynamic_cast<const Json::out_of_range*>(&error))
            throw InvalidModel("is not valid JSON: a number is out of range");
        throw InvalidModel("is not valid JSON at " + lineAndColumn(m_begin, m_end, byte));
    }

private:
    struct Object {
        std::set<std::string> keys;
        std::string latest;
    };

    bool enter() {
        constexpr int deepest = 100;
        if (++m_depth > deepest) throw InvalidModel("lists are nested too deeply");
        return true;
    }
    bool leave() {
        --m_depth;
        return true;
    }
    std::string place() const {
        std::string text;
        for (const Object& object : m_open)
            text += (text.empty() ? "" : ".") + object.latest;
        return text;
    }

    const char *m_begin, *m_end;
    int m_depth = 0;
    std::vector<Object> m_open; ///< from the outermost
};

bool ParseGuard::key(string_t& key) {
    constexpr std::size_t mostMembers = 2000;
    constexpr std::size_t longestKey = 1000; // bytes; places in messages are made of keys again and again
    if (key.size() > longestKey)
        throw InvalidModel("there is a key of " + std::to_string(key.size()) +
                           " bytes; no name is that long");
    m_open.back().latest = key;
    if (!m_open.back().keys.insert(key).second)
        throw InvalidModel(place() + " is there twice; remove or rename one");
    if (m_open.back().keys.size() > mostMembers)
        throw InvalidModel(place() + " is one member too many; an object may have " +
                           std::to_string(mostMembers));
    return true;
}

} // namespace

void guardJson(const char* begin, const char* end) {
    ParseGuard guard(begin, end);
    Json::sax_parse(begin, end, &guard);
}

Json parseJson(const char* begin, const char* end) {
    guardJson(begin, end);
    return Json::parse(begin, end);
}

Json readJsonFile(const std::filesystem::path& file) {
    constexpr std::uint64_t largest = std::uint64_t{64} << 20;
    const Bytes content = readFile(file, largest);
    const char* begin = reinterpret_cast<const char*>(content.data());
    try {
        return parseJson(begin, begin + content.size());
    } catch (const InvalidModel& error) {
        throw FileError(file, error.what());
    }
}

namespace {

std::string memberPlace(const std::string& place, const std::string& key) {
    return place.empty() ? key : place + "." + key;
}

std::string elementPlace(const std::string& place, const std::string& index) {
    return place + "[" + index + "]";
}

void collectNonFinite(const Json& json, const std::string& place, std::vector<std::string>& places) {
    if (json.is_number_float() && !std::isfinite(json.get<double>())) places.push_back(place);
    if (!json.is_structured()) return;
    for (const auto& item : json.items())
        collectNonFinite(item.value(),
                         json.is_array() ? elementPlace(place, item.key()) : memberPlace(place, item.key()),
                         places);
}

} // namespace

std::vector<std::string> nonFiniteNumbers(const Json& json) {
    std::vector<std::string> places;
    collectNonFinite(json, "", places);
    return places;
}

JsonReader::JsonReader(const Json& json, std::string place, std::vector<std::string>& problems)
    : JsonReader(&json, std::move(place), &problems) {}

bool JsonReader::has(const char* key) const {
    return m_json && m_json->is_object() && m_json->contains(key) && !m_json->at(key).is_null();
}

bool JsonReader::isObject() const {
    if (m_json && !m_json->is_object()) addProblem("should be an object in { }");
    return m_json && m_json->is_object();
}

JsonReader JsonReader::member(const char* key) const {
    std::string place = memberPlace(m_place, key);
    if (has(key)) return {&m_json->at(key), std::move(place), m_problems};
    if (isObject()) m_problems->push_back(place + " is missing");
    return {nullptr, std::move(place), m_problems};
}

std::vector<JsonReader> JsonReader::elements() const {
    std::vector<JsonReader> readers;
    if (!m_json) return readers;
    if (!m_json->is_array()) {
        addProblem("should be a list");
        return readers;
    }
    readers.reserve(m_json->size());
    for (const Json& element : *m_json)
        readers.push_back({&element, elementPlace(m_place, std::to_string(readers.size())), m_problems});
    return readers;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    std::vector<std::pair<std::string, JsonReader>> readers;
    if (!isObject()) return readers;
    for (const auto& item : m_json->items())
        readers.emplace_back(item.key(),
                             JsonReader(&item.value(), memberPlace(m_place, item.key()), m_problems));
    return readers;
}

void JsonReader::allowOnly(const std::vector<std::string>& keys) const {
    for (const auto& [key, member] : members())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            member.addProblem("is not known here; known are " + joined(keys));
}

std::string JsonReader::text() const {
    if (!m_json) return {};
    if (m_json->is_string()) return m_json->get<std::string>();
    addProblem("should be a text");
    return {};
}

bool JsonReader::flag() const {
    if (!m_json) return false;
    if (m_json->is_boolean()) return m_json->get<bool>();
    addProblem("should be true or false");
    return false;
}

double JsonReader::number() const {
    if (!m_json) return 0;
    if (m_json->is_number()) return m_json->get<double>();
    addProblem("should be a number");
    return 0;
}

std::uint64_t JsonReader::integer(std::uint64_t least, std::uint64_t most) const {
    if (!m_json) return least;
    if (m_json->is_number_unsigned() || (m_json->is_number_integer() && m_json->get<std::int64_t>() >= 0)) {
        const auto value = m_json->get<std::uint64_t>();
        if (value >= least && value <= most) return value;
    }
    addProblem("should be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return least;
}

std::vector<double> JsonReader::numbers(std::size_t size) const {
    std::vector<double> values;
    if (m_json && m_json->is_array() && m_json->size() == size)
        for (const JsonReader& element : elements())
            values.push_back(element.number());
    else if (m_json)
        addProblem("should be a list of " + std::to_string(size) + " numbers");
    values.resize(size);
    return values;
}

Eigen::Vector3d JsonReader::vector() const {
    const std::vector<double> values = numbers(3);
    return {values[0], values[1], values[2]};
}

std::vector<std::string> JsonReader::texts() const {
    std::vector<std::string> values;
    for (const JsonReader& element : elements())
        values.push_back(element.text());
    return values;
}

const Json& JsonReader::json() const {
    static const Json null;
    return m_json ? *m_json : null;
}

void JsonReader::addProblem(const std::string& problem) const {
    m_problems->push_back((m_place.empty() ? "the file" : m_place) + " " + problem);
}

void refuseNewerVersion(const JsonReader& file, int known) {
    const std::uint64_t version =
        file.member("version").integer(1, std::numeric_limits<std::uint32_t>::max());
    if (version > static_cast<std::uint64_t>(known))
        throw InvalidModel("was made by a newer version (" + std::to_string(version) +
                           ") of the program; this one reads up to " + std::to_string(known) +
                           "; update the program");
}

} // namespace esm
