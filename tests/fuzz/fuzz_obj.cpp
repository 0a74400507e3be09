#include "core/decoders/obj_mesh.h"
#include "tests/fuzz/sound_soup.h"

/// Wavefront OBJ, as the program reads it that decodes meshes.
void esm::fuzz::readInput(const Bytes& content) {
    expectSound(parseObj("input.obj", content));
}
