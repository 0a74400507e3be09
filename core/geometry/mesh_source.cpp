#include "core/geometry/mesh_source.h"

namespace esm {

std::vector<std::string> validate(const MeshSource& source) {
    constexpr std::size_t digits = 64;
    const bool isHash = source.sha256.size() == digits &&
                        source.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (isHash) return {};
    return {"the SHA-256 of the file must be 64 hexadecimal digits in small letters"};
}

} // namespace esm
