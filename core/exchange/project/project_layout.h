#pragma once

#include <cstdint>

/// What writing and reading of the project file agree on; described in `docs/project-file.md`.
namespace esm::project_layout {

constexpr const char* format = "esm-project";
constexpr const char* manifest = "manifest.json";
constexpr const char* meshVertices = "mesh/vertices.f64";
constexpr const char* meshTriangles = "mesh/triangles.u32";
constexpr const char* meshTextureCoordinates = "mesh/texture-coordinates.f64";
constexpr const char* networkNodes = "network/nodes.f64";
constexpr const char* networkSprings = "network/springs.u32";
constexpr const char* networkRestLengths = "network/rest-lengths.f64";
constexpr const char* networkVertexNodes = "network/vertex-nodes.u32";
constexpr const char* bindingStarts = "binding/starts.u32";
constexpr const char* bindingNodes = "binding/nodes.u32";
constexpr const char* bindingShares = "binding/shares.f64";
constexpr const char* bindingSurface = "binding/surface.u32";
constexpr const char* bindingLines = "binding/lines.u32";
constexpr const char* latticeTetrahedra = "lattice/tetrahedra.u32";
constexpr const char* latticeSpringShares = "lattice/spring-shares.f64";
constexpr const char* sheetSpringShares = "sheet/spring-shares.f64";
constexpr const char* sheetNodeShares = "sheet/node-shares.f64";
constexpr const char* atlasCorners = "atlas/corners.f64";
constexpr const char* atlasPages = "atlas/pages.u32";
constexpr const char* brushPoints = "painting/points.f64";
constexpr const char* brushShares = "painting/shares.f64";

/// Texels per metre that were asked for, beside what a packed atlas achieved, whose key has always been the
/// shorter one.
constexpr const char* askedOfAtlas = "askedTexelsPerMetre";

/// Bytes after decompression; what claims more is refused instead of filling the memory.
constexpr std::uint64_t largestManifest = std::uint64_t{64} << 20;
constexpr std::uint64_t largestProject = std::uint64_t{2} << 30;

} // namespace esm::project_layout
