#pragma once

#include "core/exchange/simulators/handover.h"

#include <filesystem>

namespace esm {

/// How many pages of texture an organ is handed over with; 0 without texture.
std::size_t texturePages(const Project& project);

/// "texture-1.png": what the picture of a page is called, counted from 0.
std::string textureName(std::size_t page, PictureFormat format);

/// Writes the picture of every page of the texture into a folder; none without texture.
/// @throws InvalidModel for pages that cannot be encoded; FileError, Cancelled
void writeTexturePages(const Project& project, const std::filesystem::path& folder,
                       const HandoverMeans& means);

/// Writes the drawn surface into a folder, as Wavefront's OBJ: `surface.obj` with the mesh's vertices in
/// their order, m, `surface.mtl`, and a picture for every page of the texture. Triangles stand page by page.
/// @throws InvalidModel for pages that cannot be encoded; FileError, Cancelled
void writeObjSurface(const Project& project, const std::filesystem::path& folder, const HandoverMeans& means);

} // namespace esm
