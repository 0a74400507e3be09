#pragma once

#include "core/texture/image.h"

#include <string>
#include <string_view>

namespace esm {

/// A name as Open Inventor's `DEF` takes it: letters, digits and underscores of ASCII, no digit first. What
/// is none of these becomes an underscore.
std::string inventorName(std::string_view text);

/// Text as Open Inventor's strings hold it, quotes included. Inventor has no sign for a backslash before a
/// quote or for what is no character: the one becomes a slash, the other a space.
std::string inventorString(std::string_view text);

/// The shortest decimals of the number as 32-bit float, as Inventor's are. Precondition: within their range
std::string inventorNumber(double value);

/// A row of a picture as numbers of Inventor's `SFImage`, red in the highest of three bytes.
std::string inventorPixels(const Image& image, int row);

} // namespace esm
