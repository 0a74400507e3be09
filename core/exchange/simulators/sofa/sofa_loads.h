#pragma once

#include "core/exchange/simulators/sofa/sofa_scene.h"
#include "core/exchange/simulators/xml_text.h"

namespace esm {

/// The scene's forces and led nodes, over time as the project has them.
void addSofaLoads(const SofaSubject& subject, XmlText& xml);

} // namespace esm
