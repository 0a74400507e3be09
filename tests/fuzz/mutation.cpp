#include "tests/fuzz/mutation.h"

#include "tests/fuzz/changed_json.h"
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>

namespace esm::fuzz {

std::size_t FuzzedInput::mutated() const {
    return LLVMFuzzerMutate(memory.data(), size, memory.size());
}

std::size_t FuzzedInput::replacedBy(const Bytes& other) const {
    if (other.empty() || other.size() > memory.size()) return mutated();
    std::copy(other.begin(), other.end(), memory.begin());
    return other.size();
}

Bytes mutatedPart(Bytes part, std::uint32_t seed) {
    constexpr std::size_t room = 64;
    if (seed % 4 != 0)
        if (Bytes changed = changedJson(part, seed / 4); !changed.empty()) return changed;
    const std::size_t size = part.size();
    part.resize(size + room);
    part.resize(LLVMFuzzerMutate(part.data(), size, part.size()));
    return part;
}

} // namespace esm::fuzz
