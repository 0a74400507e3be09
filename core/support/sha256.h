#pragma once

#include "core/support/file_io.h"

#include <string>

namespace esm {

/// SHA-256 (FIPS 180-4), 64 hexadecimal digits in small letters: tells one file from any other, also where
/// somebody means to deceive. @throws Cancelled
std::string sha256Of(const Bytes& bytes, const Progress& progress = {});

} // namespace esm
