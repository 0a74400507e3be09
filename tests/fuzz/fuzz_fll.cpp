#include "core/exchange/fuzzy/fll_file.h"
#include "tests/fuzz/fuzz_target.h"

/// Rule bases in FuzzyLite Language, and that what was read is written so that it comes back.
void esm::fuzz::readInput(const Bytes& content) {
    const FuzzySystem system = fuzzySystemFromFll(content).system;
    expect(validate(system).empty(), "an unsound system");
    const std::string again = toFll(system).text;
    expect(fuzzySystemFromFll({again.begin(), again.end()}).system == system, "another system:\n" + again);
}
