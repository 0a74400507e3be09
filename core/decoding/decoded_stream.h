#pragma once

#include "core/support/descriptor.h"
#include "core/support/file_io.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace esm {

/// What begins all that the decoding program hands back.
enum class DecodingOutcome : std::uint32_t { Decoded = 0x6d736501, Problem, NoMemory };

/// Writes what was decoded to a file descriptor, in this machine's own form: another process of it reads
/// that.
class DecodedWriter {
public:
    explicit DecodedWriter(int descriptor) : m_descriptor(descriptor) {}

    /// Drops what was written and begins anew. @throws std::runtime_error: not a file, or no room
    void begin(DecodingOutcome outcome);
    template<typename T> void value(const T& value) { array(&value, 1); }
    template<typename T> void array(const T* values, std::size_t count) { write(values, count * sizeof(T)); }
    void finish(); ///< hands on what is still kept back

private:
    void write(const void* data, std::size_t bytes);
    void writeOut(const void* data, std::size_t bytes);

    int m_descriptor;
    Bytes m_kept;
};

/// Reads what a decoder handed back. It cannot be trusted: a file may have taken the decoder over.
/// Every function throws FileError naming the subject where less is there than is asked for.
class DecodedStream {
public:
    /// @param subject what was decoded, as messages name it
    DecodedStream(std::filesystem::path subject, Descriptor file);

    const std::filesystem::path& subject() const { return m_subject; }
    std::uint64_t left() const { return m_left; } ///< bytes

    template<typename T> T value() {
        T value;
        read(&value, sizeof value);
        return value;
    }
    template<typename T> std::vector<T> array(std::uint64_t count) {
        if (count > m_left / sizeof(T)) failAsNonsense();
        std::vector<T> values(static_cast<std::size_t>(count));
        read(values.data(), values.size() * sizeof(T));
        return values;
    }
    [[noreturn]] void failAsNonsense() const;

private:
    void read(void* data, std::size_t bytes);

    std::filesystem::path m_subject;
    Descriptor m_file;
    std::uint64_t m_left = 0;
};

} // namespace esm
