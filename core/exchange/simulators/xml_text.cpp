#include "core/exchange/simulators/xml_text.h"

#include "core/support/numbers.h"

namespace esm {

namespace {

/// Control characters, which XML does not hold, become spaces.
std::string escapedAttribute(const std::string& value) {
    std::string text;
    for (const char letter : value) {
        if (letter == '&')
            text += "&amp;";
        else if (letter == '<')
            text += "&lt;";
        else if (letter == '"')
            text += "&quot;";
        else if (static_cast<unsigned char>(letter) < ' ')
            text += ' ';
        else
            text += letter;
    }
    return text;
}

template<typename List, typename ToText> std::string spacedList(const List& list, const ToText& toText) {
    std::string text;
    for (const auto& element : list) {
        if (!text.empty()) text += ' ';
        text += toText(element);
    }
    return text;
}

} // namespace

XmlText::XmlText(const std::string& remark)
    : m_text("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " + remark + " -->\n") {}

void XmlText::begin(const std::string& element, const XmlAttributes& attributes) {
    m_text += std::string(2 * m_open.size(), ' ') + '<' + element;
    for (const auto& [name, value] : attributes)
        m_text += ' ' + name + "=\"" + escapedAttribute(value) + '"';
}

void XmlText::open(const std::string& element, const XmlAttributes& attributes) {
    begin(element, attributes);
    m_text += ">\n";
    m_open.push_back(element);
}

void XmlText::close() {
    const std::string element = m_open.back();
    m_open.pop_back();
    m_text += std::string(2 * m_open.size(), ' ') + "</" + element + ">\n";
}

void XmlText::add(const std::string& element, const XmlAttributes& attributes) {
    begin(element, attributes);
    m_text += "/>\n";
}

std::string spaced(const std::vector<double>& numbers) {
    return spacedList(numbers, exactText);
}

std::string spaced(const std::vector<std::uint32_t>& numbers) {
    return spacedList(numbers, [](std::uint32_t number) { return std::to_string(number); });
}

std::string spaced(const Eigen::Vector3d& vector) {
    return exactText(vector.x()) + ' ' + exactText(vector.y()) + ' ' + exactText(vector.z());
}

std::string spaced(const std::vector<Eigen::Vector3d>& vectors) {
    return spacedList(vectors, [](const Eigen::Vector3d& vector) { return spaced(vector); });
}

} // namespace esm
