#include "core/decoding/decoder_program.h"

#include "core/support/child_process.h"
#include "core/support/errors.h"

#include <cstdlib>
#include <optional>
#include <vector>

/// Where the CMake package that a program found lies, told by a source that the package adds to the program:
/// it may have been moved away from where this library was configured to be installed.
extern "C" const char* esmDecoderFolder() __attribute__((weak));

namespace esm {

namespace fs = std::filesystem;

namespace {

constexpr const char *name = "esm-decode", *variable = "ESM_DECODE";

std::optional<fs::path> namedByEnvironment() {
    const char* const named = ::secure_getenv(variable);
    if (!named || !*named) return std::nullopt;
    if (!canBeRun(named))
        throw FileError(named, std::string("cannot be run, but ") + variable +
                                   " names it as the program that decodes files; name another, or none");
    return named;
}

/// Where the program lies in a build, installed with this program, and installed as the library's makers
/// meant.
std::vector<fs::path> usualPlaces() {
    std::vector<fs::path> places;
    std::error_code error;
    const fs::path running = fs::read_symlink("/proc/self/exe", error).parent_path();
    if (!error) places = {running / name, running / "../libexec/esm" / name};
    if (esmDecoderFolder) places.push_back(fs::path(esmDecoderFolder()) / name);
    places.push_back(fs::path(ESM_DECODER_FOLDER) / name);
    return places;
}

} // namespace

fs::path decoderProgram() {
    if (const auto named = namedByEnvironment()) return *named;
    std::string looked;
    for (const fs::path& place : usualPlaces()) {
        if (canBeRun(place)) return place;
        looked += (looked.empty() ? "" : ", ") + place.lexically_normal().string();
    }
    throw FileError(name, "is not there, without which no mesh and no picture can be read (looked for " +
                              looked + "); install it, or name it in the environment's " + variable);
}

} // namespace esm
