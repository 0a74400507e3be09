#pragma once

#include "core/support/file_io.h"

#include <cstdint>

namespace esm::fuzz {

/// JSON with one of its values replaced, repeated, moved or left out, as a program that is wrong would write
/// it: bytes that are changed at random seldom stay JSON. Empty where the text is none.
Bytes changedJson(const Bytes& text, std::uint32_t seed);

} // namespace esm::fuzz
