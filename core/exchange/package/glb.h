#pragma once

#include "core/support/file_io.h"
#include "core/support/json_reader.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace esm {

/// A binary glTF 2.0 file: its JSON and the bytes its buffer 0 means.
// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann-json is not seen to move without throwing
struct Glb {
    nlohmann::ordered_json json;
    Bytes binary;
};

/// The text of a JSON part, filled up with spaces to whole words of 4 bytes.
std::string jsonPart(const nlohmann::ordered_json& json);
Bytes writeGlb(const Glb& glb);  ///< @throws InvalidModel beyond the 4 GiB a GLB can hold
Glb parseGlb(const Bytes& file); ///< @throws InvalidModel: not a GLB 2.0 file, cut off or followed by more

/// The parts of a binary glTF file where they lie in it.
struct GlbParts {
    const char *json, *jsonEnd;
    const std::uint8_t *binary, *binaryEnd; ///< both null without binary data
};

/// @throws InvalidModel: not a GLB 2.0 file, or cut off
GlbParts glbParts(const Bytes& file);

/// glTF's names for what an array holds.
enum class GltfType { Scalar, Vec2, Vec3, Vec4 };
enum class GltfTarget { None = 0, Vertices = 34962, Indices = 34963 };

/// Appends arrays to a GLB, each in a buffer view of its own, and gives their places in the file.
class GltfArrays {
public:
    explicit GltfArrays(Glb& glb);

    /// Accessor of float32. Precondition: not empty, as glTF knows no empty array.
    std::size_t addFloats(const std::vector<float>& values, GltfType type,
                          GltfTarget target = GltfTarget::None);
    /// Accessor of uint32 scalars. Precondition: not empty.
    std::size_t addIndices(const std::vector<std::uint32_t>& values, GltfTarget target = GltfTarget::None);
    /// Buffer view of a file such as a picture.
    std::size_t addFile(const Bytes& content);

    std::size_t views() const; ///< so far

private:
    std::size_t addView(std::size_t begin, GltfTarget target);

    Glb& m_glb;
};

/// What is said of an array whose check sum is another.
inline constexpr auto damagedArray =
    "is damaged: its bytes are others than were written; copy the file again, or export it anew";

/// Reads the arrays of a GLB that cannot be trusted: tightly packed accessors in its binary chunk.
class GltfArrayReader {
public:
    /// Both must outlive the reader.
    /// @param damaged places of buffer views that are not to be believed
    GltfArrayReader(const Glb& glb, std::vector<std::string>& problems,
                    std::vector<std::size_t> damaged = {});

    /// The value that `reference`, a place in the JSON's list `list`, speaks of.
    JsonReader element(const char* list, const JsonReader& reference) const;

    std::size_t bytes() const { return m_glb.binary.size(); } ///< of binary data: no array has more elements
    bool foundProblems() const { return !m_problems.empty(); }
    std::size_t count(const JsonReader& accessor) const; ///< elements that an accessor claims
    /// `count` elements, finite. Empty, and a problem, where the accessor is another or damaged.
    std::vector<float> floats(const JsonReader& accessor, GltfType type, std::size_t count) const;
    /// `count` numbers below `limit`. Any, where what they count could not be read, which is told already.
    std::vector<std::uint32_t> indices(const JsonReader& accessor, std::size_t count,
                                       std::size_t limit) const;
    /// The bytes of a buffer view. None, and a problem, where it is not in the file.
    std::span<const std::uint8_t> view(const JsonReader& reference) const;
    Bytes file(const JsonReader& bufferView) const;

private:
    using Span = std::span<const std::uint8_t>;
    bool isDamaged(const JsonReader& bufferView) const;
    Span array(const JsonReader& reference, unsigned componentType, GltfType type, std::size_t count) const;

    const Glb& m_glb;
    std::vector<std::string>& m_problems;
    std::vector<std::size_t> m_damaged;
};

} // namespace esm
