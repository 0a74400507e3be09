#pragma once

#include "core/support/fields.h"

#include <string>
#include <vector>

namespace esm {

/// The keys of stored fields that none of the values sets: what brings a field brings a sample.
template<HasFields Struct> std::vector<std::string> fieldsSetInNone(const std::vector<Struct>& values) {
    std::vector<std::string> keys;
    forEachField(fieldsOf<Struct>, [&](const auto& field) {
        const auto isSetIn = [&](const Struct& value) {
            return field.belongsTo(value) && field.isSetIn(value);
        };
        if (std::none_of(values.begin(), values.end(), isSetIn)) keys.emplace_back(field.key);
    });
    return keys;
}

} // namespace esm
