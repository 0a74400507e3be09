#pragma once

#include "core/support/file_io.h"
#include "core/texture/image.h"

#include <filesystem>
#include <memory>
#include <string>

namespace esm {

/// A photograph: its file as it was read, and its pixels. Immutable once loaded.
struct Photo {
    std::string fileName; ///< without folder
    Bytes encoded;        ///< the file's bytes, kept so that a project loses nothing
    Image image;
};

/// Decodes a photo. @throws FileError when it is missing, not an image, damaged or too large
std::shared_ptr<const Photo> loadPhoto(const std::filesystem::path& file);
/// The same from bytes; `name` stands in messages.
std::shared_ptr<const Photo> decodePhoto(std::string name, Bytes encoded);

} // namespace esm
