#pragma once

#include "core/project/project.h"

#include <functional>
#include <string>
#include <vector>

namespace esm {

/// What a project file stores in one place, and how to set it: at its least, at its most and, where it may be
/// left out, unset.
struct StoredField {
    std::string name;
    std::vector<std::function<void(Project&)>> settings; ///< for projects that other fields changed as well
};

/// Of every kind of thing that a project can hold, see `docs/project-file.md`.
std::vector<StoredField> storedFields();

/// The project whose fields are set: layers that project photos in every way and one that is painted, regions
/// with and without an ellipsoid, and all else that can be there.
Project fullProject();

} // namespace esm
