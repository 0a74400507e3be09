#pragma once

#include "core/exchange/provenance.h"

#include <nlohmann/json.hpp>

namespace esm {

/// glTF's extension for what cataloguing programs read (XMP, ISO 16684, as JSON-LD).
constexpr const char* xmpExtension = "KHR_xmp_json_ld";

/// A package's provenance as such a packet: Dublin Core, and XMP's own date and tool.
nlohmann::ordered_json xmpPacket(const Provenance& provenance);

} // namespace esm
