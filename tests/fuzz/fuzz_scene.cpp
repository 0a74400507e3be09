#include "core/exchange/project/scene_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_input.h"

/// Scenes, and that what was read is written so that it comes back.
void esm::fuzz::readInput(const Bytes& content) {
    const Scene scene = sceneFromJson(jsonFrom(content));
    expect(sceneFromJson(toJson(scene)) == scene, "another scene");
}
