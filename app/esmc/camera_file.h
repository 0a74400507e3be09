#pragma once

#include "core/render/camera.h"

#include <filesystem>

namespace esm {

/// A camera in the form of a perspective projector: `pose` (16 numbers, row-major, camera → model; x right, y
/// up, looking along −z) and `fov` (vertical, degrees). @throws FileError with every problem
Camera readCameraFile(const std::filesystem::path& file);

} // namespace esm
