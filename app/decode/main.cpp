#include "app/decode/decoding_main.h"
#include "core/decoders/mesh_decoder.h"
#include "core/decoders/picture_decoders.h"
#include "core/exchange/meshes/mesh_stream.h"

#include <cstring>
#include <filesystem>
#include <optional>

namespace {

using namespace esm;

/// The problem of a FileError without the file's name, which the program that waits for it puts before it
/// again.
std::string withoutName(const std::string& message, const std::string& file) {
    const std::string name = file + ": ";
    return message.rfind(name, 0) == 0 ? message.substr(name.size()) : message;
}

void decodeMeshFile(const char* file, DecodedWriter& writer) {
    try {
        const PolygonSoup soup = decodeMesh(file);
        writer.begin(DecodingOutcome::Decoded);
        writeSoup(soup, writer);
    } catch (const FileError& error) {
        throw std::runtime_error(withoutName(error.what(), file));
    }
}

/// Goes on as the program for rare formats, which lies beside this one, with the same words, files and
/// limits.
[[noreturn]] void becomeDecoderOfRarePictures(char** words) {
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
    const std::string other = (self.parent_path() / "esm-decode-rare").string();
    ::execv(other.c_str(), words);
    throw std::runtime_error("needs the program " + other + ", which cannot be run; install it");
}

/// None for kinds that only the other program decodes.
std::optional<Image> decodeUsualPicture(ByteView encoded) {
    if (isPng(encoded)) return decodePng(encoded);
    if (isJpeg(encoded)) return decodeJpeg(encoded);
    if (isBmp(encoded)) return decodePlainBmp(encoded);
    return isTiff(encoded) ? decodePlainTiff(encoded) : std::nullopt;
}

void decodePicture(char** words, DecodedWriter& writer) {
    const ByteView encoded = standardInput();
    std::optional<Image> image;
    try {
        image = decodeUsualPicture(encoded);
    } catch (const std::runtime_error&) {
        throw std::runtime_error(undecodablePicture);
    }
    if (!image) becomeDecoderOfRarePictures(words);
    writePicture(static_cast<std::uint32_t>(image->width), static_cast<std::uint32_t>(image->height),
                 image->pixels.data(), writer);
}

void decode(char** words, DecodedWriter& writer) {
    const char* const* const task = words + 1 + limitArguments;
    if (std::strcmp(task[0], "mesh") == 0 && task[1]) return decodeMeshFile(task[1], writer);
    if (std::strcmp(task[0], "picture") == 0) return decodePicture(words, writer);
    throw std::runtime_error("nothing to decode");
}

} // namespace

/// esm-decode MEMORY OUTPUT SECONDS mesh FILE > RESULT
/// esm-decode MEMORY OUTPUT SECONDS picture < FILE > RESULT
int main(int wordCount, char** words) {
    ::_exit(esm::decodingMain(wordCount, words, decode)); // at once: the system takes all memory back quicker
}
