#pragma once

#include "core/decoding/decoded_stream.h"
#include "core/decoding/decoding_limits.h"
#include "core/support/progress.h"
#include "core/support/time_source.h"

#include <string>
#include <vector>

namespace esm {

/// One file to be decoded.
struct DecodingTask {
    std::filesystem::path subject;      ///< as messages name it
    std::vector<std::string> arguments; ///< what the decoding program is to do
    const Bytes* input = nullptr;       ///< what it finds on its standard input; null for nothing
    DecodingLimits limits;
    TimeSource clock = steadySeconds; ///< holds it to four times the processor time that it may take
};

/// Decodes a file that cannot be trusted in a process of its own, which a damaged file may crash, hang or
/// fill with gigabytes without harm to this one. May be called from any thread. A program that does not
/// ignore SIGXFSZ ends where the system limits the size of files to less than the input's.
/// @param progress asked every few hundredths of a second; how much is done is not known
/// @return what was decoded, behind its outcome
/// @throws FileError naming the subject, whatever becomes of the process; Cancelled
DecodedStream decodeApart(const DecodingTask& task, const Progress& progress);

} // namespace esm
