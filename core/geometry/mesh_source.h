#pragma once

#include "core/support/fields.h"

#include <string>
#include <vector>

namespace esm {

/// The file that a surface was read from, so that whoever has it can tell it again.
struct MeshSource {
    std::string file;   ///< its name, without the folder
    std::string sha256; ///< of all its bytes, 64 hexadecimal digits in small letters

    bool operator==(const MeshSource&) const = default;
};
template<>
inline constexpr auto fieldsOf<MeshSource> = fieldTable(field("file", &MeshSource::file),
                                                        field("sha256", &MeshSource::sha256));

/// Every problem of it. Empty when it names a file.
std::vector<std::string> validate(const MeshSource& source);

} // namespace esm
