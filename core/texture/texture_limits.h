#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// How large textures and photos may be, so that neither a slip nor a damaged file asks for all memory. What
/// exceeds them is neither made, saved nor read.
namespace esm::texture_limits {

constexpr int largestPageSize = 16384; ///< pixels, width and height
constexpr int mostPages = 64;
constexpr std::int64_t mostTexels = std::int64_t{1} << 30; ///< of all pages together

constexpr double mostTexelsPerMetre = 1e9;

constexpr std::uint64_t mostPhotoPixels =
    std::uint64_t{largestPageSize} * largestPageSize; ///< a texture page is read like a photo
constexpr std::uint64_t mostPixelsOfAllPhotos = std::uint64_t{1} << 29;

constexpr double shortestPhoto = 1e-6, longestPhoto = 1e3; ///< m, width and height of a photo in space
constexpr double narrowestView = 0.1, widestView = 170;    ///< degrees, a projector's vertical field of view
constexpr double longestFocalLength = 1e7;                 ///< photo pixels, and the principal point's place
constexpr std::size_t mostLandmarks = 10000;               ///< of one photo

constexpr std::size_t mostStrokes = 10'000;        ///< painted on one layer, or on its photo
constexpr std::size_t mostPhotoPlaces = 100'000;   ///< of all strokes on a photo
constexpr std::size_t mostBrushPoints = 1'000'000; ///< of all strokes of a layer

} // namespace esm::texture_limits

namespace esm {

struct Atlas;
struct AtlasOptions;

/// Every problem of the size of a texture. Empty when all is well.
std::vector<std::string> validate(const AtlasOptions& options);

/// Every problem of a layout for a surface of so many triangles.
std::vector<std::string> validate(const Atlas& atlas, std::size_t triangles);

} // namespace esm
