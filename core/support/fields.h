#pragma once

#include "core/support/numbers.h"
#include "core/support/words.h"

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

/// What files hold of a struct is said once, in a table beside it: member, key, limits. Reading, writing,
/// checking and the tests of these go through the table. `docs/recipes/stored_field.md` says how to add one.
namespace esm {

/// What a number may be, or each number of a list; both ends are allowed.
template<class Number> struct Limits {
    const char* name; ///< for people, as messages begin: "the opacity"
    Number least, most;
    const char* unit = "";
};

/// Of a field that any value of its type suits, or that is checked together with others.
struct Unlimited {};

/// Of a member without a key, whose own fields stand among those of the struct and have limits of their own.
struct AmongFields : Unlimited {};

constexpr Limits<double> amountLimits(const char* name, const char* unit = "") {
    return {name, 0, largestNumber, unit};
}
constexpr Limits<double> massLimits(const char* name) {
    return {name, 1 / largestNumber, largestNumber};
}
constexpr Limits<double> positiveLimits(const char* name, const char* unit = "",
                                        double most = std::numeric_limits<double>::max()) {
    return {name, std::numeric_limits<double>::denorm_min(), most, unit};
}
constexpr Limits<double> finiteLimits(const char* name) {
    return {name, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
}

/// "from 0.1 to 170 degrees", "above 0 s", "0 or more and at most 1e+30", "finite". @param most infinite
/// where only the type ends it
std::string limitsText(double least, double most, const std::string& unit);

template<class Number> std::string limitsText(const Limits<Number>& limits) {
    const bool isOpen = limits.most == std::numeric_limits<Number>::max();
    return limitsText(static_cast<double>(limits.least),
                      isOpen ? std::numeric_limits<double>::infinity() : static_cast<double>(limits.most),
                      limits.unit);
}

/// Of a number, an optional one, or all numbers of a list or vector. Not so for NaN.
template<class Value, class Number> bool isAllowed(const Value& value, const Limits<Number>& limits) {
    if constexpr (std::is_arithmetic_v<Value>)
        return value >= limits.least && value <= limits.most;
    else if constexpr (requires { value.has_value(); })
        return !value || isAllowed(*value, limits);
    else
        return std::all_of(value.begin(), value.end(),
                           [&](const auto& part) { return isAllowed(part, limits); });
}
template<class Value> bool isAllowed(const Value&, Unlimited) {
    return true;
}

/// When a file holds a field.
enum class Presence {
    Always,      ///< a file without it is faulty
    MayBeAbsent, ///< written always, but people may leave it out: then it is what the reader begins with
    WhenSet      ///< only where it is not what the struct begins with, so that older programs read the rest
};

/// One member of a struct as files hold it.
template<class Struct, class Member, class Limit> struct FileField {
    using Value = Member;
    static constexpr bool hasKey = !std::is_same_v<Limit, AmongFields>;

    const char* key;
    Member Struct::*member;
    Limit limits;
    Presence presence = Presence::Always;
    bool (*isOf)(const Struct&) = nullptr; ///< which values have the field; null: all

    constexpr FileField mayBeAbsent() const { return {key, member, limits, Presence::MayBeAbsent, isOf}; }
    constexpr FileField whenSet() const { return {key, member, limits, Presence::WhenSet, isOf}; }
    /// @param has may ask the fields that stand before this one
    constexpr FileField onlyWhere(bool (*has)(const Struct&)) const {
        return {key, member, limits, presence, has};
    }

    bool belongsTo(const Struct& value) const { return !isOf || isOf(value); }
    bool isSetIn(const Struct& value) const {
        static const Struct unset{};
        return !(value.*member == unset.*member);
    }
    bool isWrittenFor(const Struct& value) const {
        return belongsTo(value) && (presence != Presence::WhenSet || isSetIn(value));
    }
};

template<class Struct, class Member, class Limit = Unlimited>
constexpr FileField<Struct, Member, Limit> field(const char* key, Member Struct::*member, Limit limits = {}) {
    return {key, member, limits};
}

/// The member's own fields, at this place among those of the struct.
template<class Struct, class Member>
constexpr FileField<Struct, Member, AmongFields> fieldsOfMember(Member Struct::*member) {
    return {"", member, {}};
}

/// Fields in the order in which files hold them, for `forEachField()`. A closure that has caught them, since
/// every source reads the tables, and of a long `std::tuple` the compiler must prove much.
template<class... Fields> constexpr auto fieldTable(const Fields&... fields) {
    return [=](const auto& visit) { (visit(fields), ...); };
}

/// Beside a struct stands the table of its fields.
template<class Struct> inline constexpr std::nullptr_t fieldsOf = nullptr;

template<class Struct>
concept HasFields = !std::is_same_v<decltype(fieldsOf<Struct>), const std::nullptr_t>;

template<class Table, class Visit> constexpr void forEachField(const Table& table, const Visit& visit) {
    table(visit);
}

/// Every field that is beyond its limits: "the opacity must be from 0 to 1".
template<HasFields Struct> std::vector<std::string> fieldProblems(const Struct& value) {
    std::vector<std::string> problems;
    forEachField(fieldsOf<Struct>, [&](const auto& field) {
        if constexpr (requires { field.limits.name; })
            if (field.belongsTo(value) && !isAllowed(value.*field.member, field.limits))
                problems.push_back(std::string(field.limits.name) + " must be " + limitsText(field.limits));
    });
    return problems;
}

} // namespace esm
