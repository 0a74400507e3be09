#pragma once

#include "core/support/file_io.h"
#include "core/support/progress.h"
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

/// Decodes a photo, in a process of its own. @param progress asked now and then whether to go on
/// @throws FileError when it is missing, not an image, damaged or too large; Cancelled
std::shared_ptr<const Photo> loadPhoto(const std::filesystem::path& file, const Progress& progress = {});
/// The same from bytes; `name` stands in messages.
std::shared_ptr<const Photo> decodePhoto(std::string name, Bytes encoded, const Progress& progress = {});

} // namespace esm
