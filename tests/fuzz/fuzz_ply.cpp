#include "core/decoders/mesh_file_checks.h"
#include "tests/fuzz/fuzz_target.h"

/// What looks at a PLY file before and after assimp, in whose hands the program that decodes meshes leaves
/// the rest.
void esm::fuzz::readInput(const Bytes& content) {
    checkPly("input.ply", content);
    plyFaceCoordinates("input.ply", content);
}
