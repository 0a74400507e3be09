#include "tests/fuzz/mutation.h"

/// For files of JSON: called by libFuzzer in the place of its own mutation.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    const esm::fuzz::FuzzedInput input{{data, most}, size, seed};
    return input.replacedBy(esm::fuzz::mutatedPart(input.content(), seed));
}
