#include "tests/fuzz/changed_json.h"

#include "core/support/errors.h"
#include "tests/fuzz/json_input.h"

#include <random>

namespace esm::fuzz {

namespace {

using FuzzedJson = nlohmann::ordered_json;

/// A value and the list or object that it stands in; null for the outermost.
struct JsonPlace {
    FuzzedJson* value;
    FuzzedJson* around;
    std::size_t index;
};

/// The outermost first, every other behind what it stands in.
std::vector<JsonPlace> placesIn(FuzzedJson& json) {
    std::vector<JsonPlace> places{{&json, nullptr, 0}};
    for (std::size_t next = 0; next < places.size(); ++next) {
        FuzzedJson& value = *places[next].value;
        if (!value.is_structured()) continue;
        std::size_t index = 0;
        for (FuzzedJson& inner : value)
            places.push_back({&inner, &value, index++});
    }
    return places;
}

/// Values at which readers go wrong.
const std::vector<FuzzedJson>& awkwardValues() {
    static const std::vector<FuzzedJson> values{0,
                                                -1,
                                                1,
                                                0.5,
                                                -0.0,
                                                1e-320,
                                                -1e308,
                                                1e39,
                                                std::int64_t{1} << 31,
                                                std::int64_t{1} << 53,
                                                std::numeric_limits<std::int64_t>::min(),
                                                std::numeric_limits<std::uint64_t>::max(),
                                                nullptr,
                                                true,
                                                "",
                                                "a\n",
                                                FuzzedJson::array(),
                                                FuzzedJson::object()};
    return values;
}

using JsonRandom = std::minstd_rand;

template<typename List> auto& anyOf(List& list, JsonRandom& random) {
    return list[random() % list.size()];
}

void leaveOut(const JsonPlace& place) {
    if (!place.around) return;
    auto left = place.around->begin();
    std::advance(left, place.index); // members of an object are only reached one by one
    place.around->erase(left);
}

/// As one more element or, in an object, by the name of a member that is there or by a new one.
void putInto(FuzzedJson& around, const FuzzedJson& value, JsonRandom& random) {
    if (around.is_array())
        around.insert(around.begin() + static_cast<std::ptrdiff_t>(random() % (around.size() + 1)), value);
    else if (around.is_object())
        around["x" + std::to_string(random() % 3)] = value;
}

void nudge(FuzzedJson& value, JsonRandom& random) {
    if (value.is_number_integer())
        value = value.get<std::int64_t>() / 2 + static_cast<std::int64_t>(random() % 5) - 2;
    else if (value.is_number())
        value = value.get<double>() * (random() % 2 == 0 ? -1 : 1e3);
    else
        value = anyOf(awkwardValues(), random);
}

void changeOne(FuzzedJson& json, JsonRandom& random) {
    std::vector<JsonPlace> places = placesIn(json);
    const JsonPlace place = anyOf(places, random);
    const FuzzedJson other = *anyOf(places, random).value;
    switch (random() % 5) {
    case 0:
        *place.value = anyOf(awkwardValues(), random);
        break;
    case 1:
        nudge(*place.value, random);
        break;
    case 2:
        leaveOut(place);
        break;
    case 3:
        putInto(*place.value, other, random);
        break;
    default:
        *place.value = other;
    }
}

} // namespace

Bytes changedJson(const Bytes& text, std::uint32_t seed) {
    try {
        FuzzedJson json = jsonFrom(text);
        JsonRandom random(seed + 1);
        changeOne(json, random);
        const std::string changed = json.dump();
        return {changed.begin(), changed.end()};
    } catch (const InvalidModel&) {
        return {};
    }
}

} // namespace esm::fuzz
