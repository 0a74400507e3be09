#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace esm {

/// Attributes of an element, in their order; values as they are meant, not yet escaped.
using XmlAttributes = std::vector<std::pair<std::string, std::string>>;

/// XML while it grows, an element a line, those within others moved in.
class XmlText {
public:
    /// @param remark for who opens the file as text; of letters and marks without "--"
    explicit XmlText(const std::string& remark);

    void open(const std::string& element, const XmlAttributes& attributes);
    void close(); ///< the element that was opened last
    void add(const std::string& element, const XmlAttributes& attributes = {});

    const std::string& text() const { return m_text; }

private:
    void begin(const std::string& element, const XmlAttributes& attributes);

    std::string m_text;
    std::vector<std::string> m_open;
};

// Lists in an attribute: exact numbers with a space between.
std::string spaced(const std::vector<double>& numbers);
std::string spaced(const std::vector<std::uint32_t>& numbers);
std::string spaced(const Eigen::Vector3d& vector);
std::string spaced(const std::vector<Eigen::Vector3d>& vectors);

} // namespace esm
