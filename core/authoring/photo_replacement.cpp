#include "core/authoring/photo_replacement.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace esm {

namespace {

/// From pixels of one photo to those of another: the heights agree, and the middles.
class PixelMap {
public:
    PixelMap(const Image& from, const Image& to)
        : m_from(from.width / 2.0, from.height / 2.0), m_to(to.width / 2.0, to.height / 2.0),
          m_scale(static_cast<double>(to.height) / from.height) {}

    double scale() const { return m_scale; }
    Eigen::Vector2d operator()(const Eigen::Vector2d& place) const {
        return m_scale * (place - m_from) + m_to;
    }

private:
    Eigen::Vector2d m_from, m_to;
    double m_scale;
};

void scale(PhotoField& field, const PixelMap& map) {
    field.centre = map(field.centre);
    field.radii = (map.scale() * field.radii).cwiseMax(1);
    for (Eigen::Vector2d& corner : field.corners)
        corner = map(corner);
}

void scale(PhotoStroke& stroke, const PixelMap& map) {
    constexpr double least = 0.5, most = 5000; // of a stroke's radius
    for (Eigen::Vector2d& place : stroke.path)
        place = map(place);
    stroke.radius = std::clamp(map.scale() * stroke.radius, least, most);
}

void scale(Intrinsics& camera, const PixelMap& map) {
    const Eigen::Vector2d centre = map({camera.cx, camera.cy});
    camera = {map.scale() * camera.fx, map.scale() * camera.fy, centre.x(), centre.y()};
}

/// Nothing where nothing of it lies on the new photo.
std::optional<PhotoCrop> scaled(const PhotoCrop& crop, const PixelMap& map, const Image& photo) {
    const Eigen::Vector2d from = map({crop.x, crop.y}), to = map({crop.x + crop.width, crop.y + crop.height});
    const auto pixel = [](double value, int most) {
        return std::clamp(static_cast<int>(std::lround(value)), 0, most);
    };
    const int left = pixel(from.x(), photo.width), right = pixel(to.x(), photo.width);
    const int top = pixel(from.y(), photo.height), bottom = pixel(to.y(), photo.height);
    if (right <= left || bottom <= top) return std::nullopt;
    return PhotoCrop{left, top, right - left, bottom - top};
}

void scale(PhotoPreparation& preparation, const PixelMap& map, const Image& photo) {
    if (preparation.field) scale(*preparation.field, map);
    for (PhotoStroke& stroke : preparation.strokes)
        scale(stroke, map);
    if (preparation.lens) scale(preparation.lens->camera, map);
    if (preparation.crop) preparation.crop = scaled(*preparation.crop, map, photo);
}

std::string stemOf(const Photo& photo) {
    return std::filesystem::path(photo.fileName).stem().string();
}

std::string sizeInText(const Image& photo) {
    return std::to_string(photo.width) + " × " + std::to_string(photo.height) + " pixels";
}

} // namespace

bool haveOneShape(const Image& a, const Image& b) {
    const double scale = static_cast<double>(b.height) / a.height;
    return std::abs(a.width * scale - b.width) <= std::max(1.0, scale);
}

TextureLayer withPhoto(const TextureLayer& layer, std::shared_ptr<const Photo> photo,
                       const Progress& progress) {
    const Image &before = layer.photo->image, &after = photo->image;
    const PixelMap map(before, after);
    TextureLayer made = layer;
    if (made.name == stemOf(*layer.photo)) made.name = stemOf(*photo);
    made.blendPixels *= map.scale();
    made.projector.width *= after.width / (map.scale() * before.width);
    if (made.projector.intrinsics) scale(*made.projector.intrinsics, map);
    for (LandmarkPair& pair : made.landmarks)
        pair.photo = map(pair.photo);
    made.photo = std::move(photo);
    PhotoPreparation preparation = layer.preparation;
    scale(preparation, map, after);
    prepare(made, preparation, progress);
    return made;
}

std::vector<std::string> replacementRemarks(const TextureLayer& before, const TextureLayer& after) {
    std::vector<std::string> remarks;
    if (!haveOneShape(before.photo->image, after.photo->image))
        remarks.push_back(
            "the new photo has another shape (" + sizeInText(after.photo->image) + " in place of " +
            sizeInText(before.photo->image) +
            "): its height and its middle stay where they are on the organ, and it shows more or "
            "less at its sides");
    if (before.preparation.crop && !after.preparation.crop)
        remarks.emplace_back("nothing of the new photo lies in the frame of the crop, which is dropped");
    const PhotoPreparation& kept = before.preparation;
    if (kept.whiteBalance || kept.match || kept.adjustment != ColourAdjustment())
        remarks.emplace_back("white balance, matched and adjusted colours are those of the photo before; "
                             "find them anew where the new one has other colours");
    return remarks;
}

} // namespace esm
