#include "core/geometry/mesh_source.h"

#include "core/support/text_line.h"

namespace esm {

std::vector<std::string> validate(const MeshSource& source) {
    constexpr std::size_t mostBytes = 1000; // some four times what a file system takes
    constexpr std::size_t digits = 64;
    std::vector<std::string> problems;
    if (const std::string problem = lineProblem(source.file, mostBytes); !problem.empty())
        problems.push_back("the file's name " + problem);
    const bool isHash = source.sha256.size() == digits &&
                        source.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!isHash)
        problems.emplace_back("the SHA-256 of the file must be 64 hexadecimal digits in small letters");
    return problems;
}

} // namespace esm
