#include "core/decoders/vtk_polydata.h"
#include "tests/fuzz/sound_soup.h"

/// Legacy VTK, as the program reads it that decodes meshes.
void esm::fuzz::readInput(const Bytes& content) {
    expectSound(parseVtkPolydata("input.vtk", content));
}
