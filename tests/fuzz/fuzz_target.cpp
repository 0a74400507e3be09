#include "tests/fuzz/fuzz_target.h"

#include "core/support/atomic_file.h"
#include "core/support/errors.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

namespace esm::fuzz {

void expect(bool holds, std::string_view what) {
    if (holds) return;
    std::fprintf(stderr, "finding: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

FileInMemory::FileInMemory(const Bytes& content) : m_descriptor(::memfd_create("input", MFD_CLOEXEC)) {
    const std::string_view bytes(reinterpret_cast<const char*>(content.data()), content.size());
    expect(m_descriptor >= 0 && writeWhole(m_descriptor, bytes), "no memory for a file");
}

FileInMemory::~FileInMemory() {
    ::close(m_descriptor);
}

std::filesystem::path FileInMemory::path() const {
    return "/proc/self/fd/" + std::to_string(m_descriptor);
}

} // namespace esm::fuzz

/// Pictures within files stay as they are: for each a program would be started that decodes it.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    return ::setenv("ESM_DECODE", "/dev/null", 1);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        esm::fuzz::readInput(esm::Bytes(data, data + size));
    } catch (const esm::FileError& refusal) {
        esm::fuzz::expect(*refusal.what() != '\0', "refused without a word");
    } catch (const esm::InvalidModel& refusal) {
        esm::fuzz::expect(*refusal.what() != '\0', "refused without a word");
    }
    return 0;
}
