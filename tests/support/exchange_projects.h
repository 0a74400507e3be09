#pragma once

#include "core/project/project.h"

#include <cstdint>

namespace esm {

/// A photo of `size` pixels squared with a colour gradient and a border that fades away.
std::shared_ptr<const Photo> gradientPhoto(const std::string& fileName, int size);

/// An organ that uses everything a project can hold, with numbers that no decimal notation keeps by chance.
/// The organ is a ring of `rings` · 12 triangles, 0.07 m in radius.
Project richProject(std::uint32_t rings = 8);

/// With a wet look: of the organ, of photos with relief and highlights, of a layer that lends no colour.
Project shiningProject();

/// The same organ carried by fewer nodes than it has vertices, or moved rigidly.
Project boundProject(const Detail& detail);

/// The same organ in a lattice of one box, whose eight nodes turn nothing: up to eight carry each vertex.
Project latticeProject();

/// The same organ of a wall of another thickness, its tissue said in Young's modulus and relaxation time.
Project clinicalProject();
/// The same organ as an even sheet, without photos.
Project sheetProject();
/// The same organ filled with a lattice, without photos.
Project filledProject();

/// The same organ carried by its simulated surface, each vertex by as many nodes of it, from anywhere.
/// @param length at most 19
Project rowsProject(std::size_t length);

/// The same organ of biphasic springs.
Project biphasicProject();

/// The same organ with norms, weights and conditions of every kind in its regions' fuzzy system.
Project extendedInferenceProject();

/// The same organ with a region that fades into what lies beneath.
Project softProject();

/// The same organ with strokes of every brush, layers that blend in every way and one without a photo.
Project paintedProject();

/// The same organ with texture coordinates that unroll the ring onto a picture, laid out by them: 15 of its
/// vertices lie at two places or more there, which makes 63 of 48.
Project ownLayoutProject();

/// Nodes and springs without a surface, as the uterus' motion model.
Project bareProject();

} // namespace esm
