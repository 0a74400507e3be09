#pragma once

#include "core/support/scratch_folder.h"

#include <string>

/// A new empty folder that goes away with the object.
class TemporaryFolder : public esm::ScratchFolder {
public:
    std::filesystem::path operator/(const std::string& name) const { return path() / name; }
};
