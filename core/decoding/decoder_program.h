#pragma once

#include <filesystem>

namespace esm {

/// The program `esm-decode`, in which files of foreign formats are decoded: what the environment's ESM_DECODE
/// names, or else beside the running program, or else in `../libexec/esm` from there, or else where this
/// library was installed.
/// @throws FileError naming the places when it is in none: nothing is decoded in the calling process in its
/// place
std::filesystem::path decoderProgram();

} // namespace esm
