#include "core/exchange/project/projector_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_input.h"

/// Projectors, and that what was read is written so that it comes back.
void esm::fuzz::readInput(const Bytes& content) {
    const Projector projector = projectorFromJson(jsonFrom(content));
    const Projector again = projectorFromJson(toJson(projector));
    expect(toJson(again) == toJson(projectorFromJson(toJson(again))), "another projector");
}
