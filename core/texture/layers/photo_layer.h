#pragma once

#include "core/support/file_io.h"
#include "core/texture/image.h"
#include "core/texture/photo/photo_preparation.h"
#include "core/texture/projection/projector.h"

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

/// A photo on the organ. Never baked in: layers are composed anew when one changes.
struct PhotoLayer {
    std::string name;
    std::shared_ptr<const Photo> photo; ///< never null
    Projector projector;
    double blendPixels = 24; ///< photo pixels over which the weight rises from 0 at the border to 1 [R 4.3.3]
    double opacity = 1;      ///< 0 to 1
    bool visible = true;
    PhotoPreparation preparation;
    std::shared_ptr<const Image> prepared; ///< what it makes of the photo; null where it does nothing
};

/// What the projector throws: the prepared picture, or the photo's own.
std::shared_ptr<const Image> pictureOf(const PhotoLayer& layer);

/// Gives a layer another preparation and the picture that comes of it, or leaves it as it was.
/// @throws InvalidModel with what validate() finds
void prepare(PhotoLayer& layer, const PhotoPreparation& preparation);

/// Decodes a photo. @throws FileError when it is missing, not an image, damaged or too large
std::shared_ptr<const Photo> loadPhoto(const std::filesystem::path& file);
/// The same from bytes; `name` stands in messages.
std::shared_ptr<const Photo> decodePhoto(std::string name, Bytes encoded);

} // namespace esm
