#pragma once

#include "app/editor/workers/poke_motion.h"
#include "core/render/renderer.h"

#include <filesystem>

namespace esm {

/// What is filmed: the motion of a poke, and beside it what it was before.
struct PokeFilm {
    RenderScene scene; ///< as the view shows the organ
    Camera camera;
    double aspect = 4.0 / 3; ///< width over height of the view
    std::shared_ptr<const PokeMotion> now;
    std::shared_ptr<const PokeMotion> before; ///< null: nothing is beside it
};

/// Every picture as PNG: of "poke.png" poke-0001.png and so on. @throws FileError where one of these is there
/// already, or cannot be written; those that were written are gone then. @throws Cancelled
void writeFilmPictures(const PokeFilm& film, const std::filesystem::path& file,
                       const Progress& progress = {});

/// A film that runs as fast as the tissue moves, Motion JPEG in AVI. @throws FileError @throws Cancelled
void writeFilm(const PokeFilm& film, const std::filesystem::path& file, const Progress& progress = {});

} // namespace esm
