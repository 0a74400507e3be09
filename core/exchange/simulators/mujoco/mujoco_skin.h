#pragma once

#include "core/exchange/simulators/handover.h"
#include "core/exchange/simulators/xml_text.h"

#include <string>

namespace esm {

/// "node12": the body of a node.
std::string mujocoBodyName(std::uint32_t node);

/// The drawn surface as skins that follow the bodies of its nodes, one for each page of the texture, with
/// their materials and pictures. A body that only slides turns nothing that it carries.
void addMujocoSkins(const Handover& handover, XmlText& xml);

} // namespace esm
