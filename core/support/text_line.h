#pragma once

#include <cstddef>
#include <string>

namespace esm {

/// "must be one line without control characters"; empty when it is a line of UTF-8 of so many bytes at most,
/// which may be shown anywhere.
std::string lineProblem(const std::string& text, std::size_t mostBytes);

/// The text with U+FFFD for each control character and for what is no UTF-8.
std::string asLine(const std::string& text);

} // namespace esm
