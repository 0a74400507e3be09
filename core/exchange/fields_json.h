#pragma once

#include "core/support/fields.h"
#include "core/support/json_reader.h"

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Structs that have a table of fields (`core/support/fields.h`) as objects in JSON.
///
/// How a value stands there is looked for in this order: what the file's forms say, a toJson() and fromJson()
/// of its own, a list, a value or nothing, the word of an enumeration, an object by its table of fields.
namespace esm {

/// A file's own forms have `write(value)` and `read(reader, value)` for kinds that stand otherwise in that
/// file, for example by their place in a list. Of these there are none.
struct PlainForms {};

/// Of files that people type: a key that is not known is a problem, since a misspelt one would be lost, and
/// what is beyond its limits is told by its place.
struct TypedForms {
    static constexpr bool areTyped = true;
};

inline void fromJson(const JsonReader& reader, bool& value) {
    value = reader.flag();
}
inline void fromJson(const JsonReader& reader, double& value) {
    value = reader.number();
}
inline void fromJson(const JsonReader& reader, std::string& value) {
    value = reader.text();
}
inline void fromJson(const JsonReader& reader, Eigen::Vector3d& value) {
    value = reader.vector();
}
void fromJson(const JsonReader& reader, Eigen::Vector2d& value);
void fromJson(const JsonReader& reader, std::array<double, 3>& value);
/// A colour: red, green, blue.
void fromJson(const JsonReader& reader, std::array<std::uint8_t, 3>& value);

template<std::unsigned_integral Number>
requires(!std::same_as<Number, bool>) void fromJson(const JsonReader& reader, Number& value) {
    value = static_cast<Number>(reader.integer(0, std::numeric_limits<Number>::max()));
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words);

template<HasWords Enum> void fromJson(const JsonReader& reader, Enum& value) {
    const std::optional<Enum> found = fromWord<Enum>(reader.text());
    if (found) value = *found;
    if (!found && reader.json().is_string()) reader.addProblem("should be " + alternatives(allWords<Enum>()));
}

/// Takes what the object has into `value`, whose fields that may be absent stay as they are without.
template<class Struct, class Forms = PlainForms, class Table = decltype(fieldsOf<Struct>)>
void readFields(const JsonReader& reader, Struct& value, const Forms& forms = {},
                const Table& table = fieldsOf<Struct>);

/// The fields that the value has, in the table's order.
template<class Struct, class Forms = PlainForms, class Table = decltype(fieldsOf<Struct>)>
nlohmann::ordered_json writtenFields(const Struct& value, const Forms& forms = {},
                                     const Table& table = fieldsOf<Struct>);

template<class Value, class Forms>
void readValue(const JsonReader& reader, Value& value, const Forms& forms) {
    if constexpr (requires { forms.read(reader, value); }) {
        forms.read(reader, value);
    } else if constexpr (requires { fromJson(reader, value); }) {
        fromJson(reader, value);
    } else if constexpr (requires { value.emplace(); }) {
        readValue(reader, value.emplace(), forms);
    } else if constexpr (HasFields<Value>) {
        readFields(reader, value, forms);
    } else {
        for (const JsonReader& element : reader.elements())
            readValue(element, value.emplace_back(), forms);
    }
}

template<class Value, class Forms = PlainForms>
Value valueFrom(const JsonReader& reader, const Forms& forms = {}) {
    Value value{};
    readValue(reader, value, forms);
    return value;
}

template<class Value, class Forms = PlainForms>
nlohmann::ordered_json written(const Value& value, const Forms& forms = {}) {
    using Json = nlohmann::ordered_json;
    if constexpr (requires { forms.write(value); }) {
        return forms.write(value);
    } else if constexpr (requires { toJson(value); }) {
        return toJson(value);
    } else if constexpr (requires { value.has_value(); }) {
        return written(*value, forms);
    } else if constexpr (HasWords<Value>) {
        return wordOf(value);
    } else if constexpr (HasFields<Value>) {
        return writtenFields(value, forms);
    } else if constexpr (std::is_constructible_v<Json, Value>) {
        return value;
    } else {
        Json list = Json::array();
        for (const auto& element : value)
            list.push_back(written(element, forms));
        return list;
    }
}

template<class Table> std::vector<std::string> keysOf(const Table& table) {
    std::vector<std::string> keys;
    forEachField(table, [&](const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (Field::hasKey)
            keys.emplace_back(field.key);
        else
            for (std::string& key : keysOf(fieldsOf<typename Field::Value>))
                keys.push_back(std::move(key));
    });
    return keys;
}

template<class Forms>
concept Typed = requires {
    requires Forms::areTyped;
};

/// Numbers that were not read, which is told already, are not told again.
template<class Value, class Limit>
void checkLimits(const JsonReader& reader, const Value& value, const Limit& limits) {
    if constexpr (requires { limits.name; })
        if (reader.json().is_number() && !isAllowed(value, limits))
            reader.addProblem("must be " + limitsText(limits));
}

template<class Value, class Limit, class Forms>
void readMember(const JsonReader& reader, Value& value, const Limit& limits, const Forms& forms) {
    if constexpr (requires { requires std::integral<decltype(limits.least)>; }) {
        using Number = decltype(limits.least);
        value = static_cast<Number>(reader.integer(static_cast<std::uint64_t>(limits.least),
                                                   static_cast<std::uint64_t>(limits.most)));
    } else {
        readValue(reader, value, forms);
        if constexpr (Typed<Forms>) checkLimits(reader, value, limits);
    }
}

template<class Struct, class Forms, class Table>
void readMembers(const JsonReader& reader, Struct& value, const Forms& forms, const Table& table) {
    forEachField(table, [&](const auto& field) {
        using Field = std::remove_cvref_t<decltype(field)>;
        if constexpr (!Field::hasKey)
            readMembers(reader, value.*field.member, forms, fieldsOf<typename Field::Value>);
        else if (field.belongsTo(value) && (field.presence == Presence::Always || reader.has(field.key)))
            readMember(reader.member(field.key), value.*field.member, field.limits, forms);
    });
}

template<class Struct, class Forms, class Table>
void readFields(const JsonReader& reader, Struct& value, const Forms& forms, const Table& table) {
    if constexpr (Typed<Forms>) reader.allowOnly(keysOf(table));
    if (Typed<Forms> ? reader.json().is_object() : reader.isObject())
        readMembers(reader, value, forms, table);
}

template<class Struct, class Forms, class Table>
nlohmann::ordered_json writtenFields(const Struct& value, const Forms& forms, const Table& table) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    forEachField(table, [&](const auto& field) {
        if constexpr (!std::remove_cvref_t<decltype(field)>::hasKey)
            json.update(writtenFields(value.*field.member, forms));
        else if (field.isWrittenFor(value))
            json[field.key] = written(value.*field.member, forms);
    });
    return json;
}

} // namespace esm
