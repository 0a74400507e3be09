#pragma once

#include "core/exchange/project/content_entries.h"

namespace esm {

/// The drawn surface. @param arrays the manifest's list of them
std::shared_ptr<const TriangleMesh> readMesh(const JsonReader& arrays, ContentEntries& source);

/// The nodes and springs, how they carry the surface, and what fills it.
std::shared_ptr<const SpringNetwork> readNetwork(const JsonReader& manifest, ContentEntries& source);

} // namespace esm
