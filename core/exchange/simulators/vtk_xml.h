#pragma once

#include "core/support/byte_order.h"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace esm {

/// One of VTK's arrays.
struct VtkArray {
    std::string name, unit; ///< the unit may be empty
    std::size_t components = 1;
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>,
                 std::vector<std::uint8_t>, std::vector<std::string>>
        values; ///< tuple after tuple
};

/// VTK's XML while it grows. Arrays follow each other as raw bytes behind the last element ("appended"), each
/// after its length in 64 bits. That is VTK's own default: half the size of text and exact, and any version
/// from 5 on reads it.
class VtkXml {
public:
    /// @param kind "PolyData", and as its element
    explicit VtkXml(std::string kind);

    void add(const std::string& line) { m_text += line + '\n'; }
    void addArray(const VtkArray& array);
    /// The whole file. Its elements that were opened are closed by who opened them.
    Bytes finished() const;

private:
    template<typename Number>
    void addNumbers(const VtkArray& array, const std::string& type, const std::vector<Number>& values);
    void addWords(const VtkArray& array, const std::vector<std::string>& words);

    std::string m_kind, m_text;
    Bytes m_bytes;
};

} // namespace esm
