#pragma once

#include "core/support/file_io.h"
#include "core/support/json_reader.h"

namespace esm::fuzz {

/// @throws InvalidModel
inline nlohmann::ordered_json jsonFrom(const Bytes& content) {
    const char* const begin = reinterpret_cast<const char*>(content.data());
    return parseJson(begin, begin + content.size());
}

} // namespace esm::fuzz
