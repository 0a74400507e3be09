#include "core/exchange/fuzzy/fcl_file.h"
#include "tests/fuzz/fuzz_target.h"

/// Rule bases in Fuzzy Control Language, and that what was read is written so that it comes back.
void esm::fuzz::readInput(const Bytes& content) {
    const FuzzySystem system = fuzzySystemFromFcl(content).system;
    expect(validate(system).empty(), "an unsound system");
    const std::string again = toFcl(system).text;
    expect(fuzzySystemFromFcl({again.begin(), again.end()}).system == system, "another system:\n" + again);
}
