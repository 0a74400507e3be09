#pragma once

#include "core/render/camera.h"
#include "core/texture/projection/projector.h"

#include <filesystem>

namespace esm {

/// A camera in the form of a perspective projector, see `docs/command-line.md`. Its intrinsics are in pixels
/// of the picture that is drawn. @throws FileError with every problem
Camera readCameraFile(const std::filesystem::path& file, PhotoSize picture);

} // namespace esm
