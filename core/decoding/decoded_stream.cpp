#include "core/decoding/decoded_stream.h"

#include "core/support/errors.h"

#include <cerrno>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace esm {

/// Begins anew, whatever was written before: a decoder that runs out of memory halfway can still say so.
void DecodedWriter::begin(DecodingOutcome outcome) {
    m_kept.clear();
    if (::lseek(m_descriptor, 0, SEEK_SET) != 0 || ::ftruncate(m_descriptor, 0) != 0)
        throw std::runtime_error("the result can only be written to a file");
    value(outcome);
}

/// Small values are gathered: a system call for each number of a mesh would take longer than decoding it.
void DecodedWriter::write(const void* data, std::size_t bytes) {
    constexpr std::size_t most = 1 << 20;
    const auto* begin = static_cast<const std::uint8_t*>(data);
    if (m_kept.size() + bytes > most) finish();
    if (bytes > most)
        writeOut(begin, bytes);
    else
        m_kept.insert(m_kept.end(), begin, begin + bytes);
}

void DecodedWriter::finish() {
    writeOut(m_kept.data(), m_kept.size());
    m_kept.clear();
}

void DecodedWriter::writeOut(const void* data, std::size_t bytes) {
    const auto* place = static_cast<const std::uint8_t*>(data);
    while (bytes > 0) {
        const ssize_t written = ::write(m_descriptor, place, bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw std::runtime_error("the result cannot be written");
        place += written;
        bytes -= static_cast<std::size_t>(written);
    }
}

DecodedStream::DecodedStream(std::filesystem::path subject, Descriptor file)
    : m_subject(std::move(subject)), m_file(std::move(file)) {
    struct stat status {};
    if (::fstat(m_file.number(), &status) != 0 || ::lseek(m_file.number(), 0, SEEK_SET) != 0)
        failAsNonsense();
    m_left = static_cast<std::uint64_t>(status.st_size);
}

/// What comes back may be made to do harm: a decoder that was taken over writes what it likes. So no length
/// is believed before the bytes are there.
void DecodedStream::read(void* data, std::size_t bytes) {
    if (bytes > m_left) failAsNonsense();
    auto* place = static_cast<std::uint8_t*>(data);
    m_left -= bytes;
    while (bytes > 0) {
        const ssize_t count = ::read(m_file.number(), place, bytes);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) failAsNonsense();
        place += count;
        bytes -= static_cast<std::size_t>(count);
    }
}

void DecodedStream::failAsNonsense() const {
    throw FileError(m_subject,
                    "cannot be decoded: what came back of it makes no sense, so the file may be damaged "
                    "or made to do harm; export it again");
}

} // namespace esm
