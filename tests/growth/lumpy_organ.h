#pragma once

#include <cstddef>
#include <filesystem>

namespace growth {

/// Writes a closed surface of irregular triangles, lumpy like an organ, with a second part beside it, as PLY.
/// Vertices along some seams are written more than once, as files often have them.
/// @return how many triangles it has, about as many as asked for
std::size_t writeLumpyOrgan(const std::filesystem::path& file, std::size_t triangles);

} // namespace growth
