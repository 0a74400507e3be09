#pragma once

#include "core/exchange/package/glb.h"

#include <string>
#include <vector>

namespace esm {

/// Adds the array of check sums, still empty, and gives its place. Precondition: all others are there.
std::size_t addChecksums(GltfArrays& arrays);

/// Fills that array in. Precondition: it was added, and nothing of the file changes any more.
void fillChecksums(Glb& glb);

/// The buffer views whose bytes are others than were written, the first 20 of them; none of files of before
/// there were check sums. Problems: a damaged JSON, since it could name any bytes, check sums that cannot be
/// read, and views that overlap.
/// @param file that the GLB was parsed from
std::vector<std::size_t> damagedViews(const Bytes& file, const Glb& glb, std::vector<std::string>& problems);

/// What damaged views hold, by what draws it, for those that nobody has read.
std::vector<std::string> damageProblems(const Glb& glb, const std::vector<std::size_t>& damaged);

} // namespace esm
