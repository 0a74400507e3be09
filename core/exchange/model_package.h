#pragma once

#include "core/exchange/package/packaged_tissue.h"
#include "core/exchange/simulators/handover.h"
#include "core/texture/layers/tiled_pages.h"

#include <filesystem>
#include <functional>

namespace esm {

/// All that a package holds; numbers are the project's, rounded to 32-bit floats.
struct ModelPackage : PackagedTissue {
    BaseTissue base{}; ///< for people: already in `tissue`, as the regions are
    std::vector<Region> regions{};
    std::array<std::uint8_t, 3> baseColour{}; ///< of a surface without texture
    std::shared_ptr<const Atlas> atlas{};     ///< null without textures
    std::vector<Image> textures{};            ///< one per page of the atlas
    std::optional<SurfaceFinish> finish{};    ///< of all the surface; none where pages say it, or nothing
    std::shared_ptr<const TiledPages>
        finishPages{}; ///< like the textures, see `composedFinish`; null without
    Image preview{};   ///< of the organ, for lists of packages; empty without one
};

/// Bakes the textures and writes the package atomically, with a preview where one can be drawn.
/// @throws InvalidModel for numbers that 32-bit floats cannot hold; FileError, Cancelled; what drawing throws
void writePackage(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means);

/// True for a model package, false for what should be a project; told by the first bytes, else by the name.
bool isModelPackage(const std::filesystem::path& file);

struct OpenedPackage {
    ModelPackage package;
    std::vector<std::string> warnings; ///< what is wrong with the file, though it can be worked with
};

/// @throws FileError: damaged, or not a model package, or of a newer version
OpenedPackage openPackage(const std::filesystem::path& file);

/// The same for who has nobody to warn.
ModelPackage loadPackage(const std::filesystem::path& file);

/// All problems at once, and all that opening warns of; empty when the package is whole. @throws FileError
/// when there is no file to read
std::vector<std::string> validatePackage(const std::filesystem::path& file);

} // namespace esm
