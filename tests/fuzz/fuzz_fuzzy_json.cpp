#include "core/exchange/fuzzy/fuzzy_file.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_input.h"

/// Fuzzy systems in JSON, and that what was read is written so that it comes back.
void esm::fuzz::readInput(const Bytes& content) {
    const FuzzySystem system = fuzzySystemFromJson(jsonFrom(content));
    expect(validate(system).empty(), "an unsound system");
    expect(fuzzySystemFromJson(toJson(system)) == system, "another system");
}
