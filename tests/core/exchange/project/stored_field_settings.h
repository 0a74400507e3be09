#pragma once

#include "tests/core/exchange/project/stored_fields.h"

#include <limits>
#include <vector>

/// How stored fields are written down.
namespace esm::stored {

using Setting = std::function<void(Project&)>;
using Fields = std::vector<StoredField>;

inline constexpr double smallest = std::numeric_limits<double>::denorm_min(),
                        largest = std::numeric_limits<double>::max();

/// Sets a value of what `find` finds in a project, or nothing where it finds none.
template<class Find, class Value> Setting setTo(const Find& find, const Value& value) {
    return [find, value](Project& project) {
        if (auto* found = find(project)) *found = value;
    };
}

/// A field for which each value is set in turn.
template<class Value, class Find>
StoredField field(const char* name, const std::vector<Value>& values, const Find& find) {
    StoredField result{name, {}};
    for (const Value& value : values)
        result.settings.push_back(setTo(find, value));
    return result;
}

/// `part` of what `find` finds, or nothing.
template<class Find, class Part> auto partOf(const Find& find, const Part& part) {
    return [find, part](Project& project) { return find(project) ? part(*find(project)) : nullptr; };
}

/// All that has a table of fields.
void addTables(Fields& fields);

/// What of photos and paintings has no table, or is bound further.
void addPhotoFields(Fields& fields);

} // namespace esm::stored
