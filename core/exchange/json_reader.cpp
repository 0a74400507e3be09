#include "core/exchange/json_reader.h"

#include "core/support/errors.h"

#include <cmath>

namespace esm {

using Json = nlohmann::ordered_json;

Json parseJson(const char* begin, const char* end) {
    constexpr int deepest = 100;
    const auto refuseDepth = [](int depth, Json::parse_event_t, const Json&) {
        if (depth > deepest) throw InvalidModel("lists are nested too deeply");
        return true;
    };
    try {
        return Json::parse(begin, end, refuseDepth);
    } catch (const Json::parse_error& error) {
        throw InvalidModel("is not valid JSON at byte " + std::to_string(error.byte));
    } catch (const Json::exception&) {
        throw InvalidModel("is not valid JSON: a number is out of range");
    }
}

namespace {

void collectNonFinite(const Json& json, const std::string& place, std::vector<std::string>& places) {
    if (json.is_number_float() && !std::isfinite(json.get<double>())) places.push_back(place);
    if (!json.is_structured()) return;
    for (const auto& item : json.items())
        collectNonFinite(item.value(), place.empty() ? item.key() : place + "/" + item.key(), places);
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

JsonReader JsonReader::member(const char* key) const {
    std::string place = m_place.empty() ? key : m_place + "/" + key;
    if (has(key)) return {&m_json->at(key), std::move(place), m_problems};
    if (m_json) m_problems->push_back(place + " is missing");
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
        readers.push_back({&element, m_place + "/" + std::to_string(readers.size()), m_problems});
    return readers;
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
    if (m_json->is_number_unsigned()) {
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
    m_problems->push_back(m_place + " " + problem);
}

} // namespace esm
