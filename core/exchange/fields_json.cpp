#include "core/exchange/fields_json.h"

#include "core/support/joined.h"

#include <algorithm>

namespace esm {

std::string alternatives(const std::vector<std::string>& words) {
    if (words.size() < 2) return joined(words);
    return joined({words.begin(), words.end() - 1}) + " or " + words.back();
}

void fromJson(const JsonReader& reader, Eigen::Vector2d& value) {
    const std::vector<double> numbers = reader.numbers(2);
    value = {numbers[0], numbers[1]};
}

void fromJson(const JsonReader& reader, std::array<double, 3>& value) {
    const std::vector<double> numbers = reader.numbers(3);
    std::copy(numbers.begin(), numbers.end(), value.begin());
}

void fromJson(const JsonReader& reader, std::array<std::uint8_t, 3>& value) {
    const std::vector<JsonReader> channels = reader.elements();
    if (channels.size() != value.size() && !reader.json().is_null())
        reader.addProblem("should be three numbers: red, green, blue");
    for (std::size_t i = 0; i < std::min(channels.size(), value.size()); ++i)
        value[i] = static_cast<std::uint8_t>(channels[i].integer(0, 255));
}

} // namespace esm
