#include "core/exchange/simulators/vtk_xml.h"

namespace esm {

namespace {

std::string vtkAttribute(const std::string& name, const std::string& value) {
    return ' ' + name + "=\"" + value + '"';
}

std::string vtkAttributes(const VtkArray& array, const std::string& type, std::size_t count) {
    return vtkAttribute("type", type) + vtkAttribute("Name", array.name) +
           vtkAttribute("NumberOfComponents", std::to_string(array.components)) +
           vtkAttribute("NumberOfTuples", std::to_string(count / array.components));
}

} // namespace

VtkXml::VtkXml(std::string kind) : m_kind(std::move(kind)) {
    add(R"(<?xml version="1.0" encoding="UTF-8"?>)");
    add("<VTKFile" + vtkAttribute("type", m_kind) +
        R"( version="1.0" byte_order="LittleEndian" header_type="UInt64">)");
    add('<' + m_kind + '>');
}

template<typename Number>
void VtkXml::addNumbers(const VtkArray& array, const std::string& type, const std::vector<Number>& values) {
    add("<DataArray" + vtkAttributes(array, type, values.size()) + vtkAttribute("format", "appended") +
        vtkAttribute("offset", std::to_string(m_bytes.size())) + '>');
    if (!array.unit.empty())
        add(R"(<InformationKey name="UNITS_LABEL" location="vtkDataArray">)" + array.unit +
            "</InformationKey>");
    add("</DataArray>");
    appendLittleEndian(m_bytes, std::uint64_t{values.size() * sizeof(Number)});
    for (const Number value : values)
        if constexpr (sizeof(Number) == 1)
            m_bytes.push_back(value);
        else
            appendLittleEndian(m_bytes, value);
}

/// Words stand as the numbers of their bytes, each with a 0 at its end: so any text is well-formed XML.
void VtkXml::addWords(const VtkArray& array, const std::vector<std::string>& words) {
    std::string codes;
    for (const std::string& word : words) {
        for (const char c : word)
            codes += std::to_string(static_cast<unsigned char>(c)) + ' ';
        codes += "0 ";
    }
    add("<Array" + vtkAttributes(array, "String", words.size()) + vtkAttribute("format", "ascii") + '>');
    add(codes);
    add("</Array>");
}

void VtkXml::addArray(const VtkArray& array) {
    if (const auto* doubles = std::get_if<std::vector<double>>(&array.values))
        addNumbers(array, "Float64", *doubles);
    else if (const auto* integers = std::get_if<std::vector<std::int32_t>>(&array.values))
        addNumbers(array, "Int32", *integers);
    else if (const auto* places = std::get_if<std::vector<std::int64_t>>(&array.values))
        addNumbers(array, "Int64", *places);
    else if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&array.values))
        addNumbers(array, "UInt8", *bytes);
    else
        addWords(array, std::get<std::vector<std::string>>(array.values));
}

Bytes VtkXml::finished() const {
    const std::string begin = m_text + "</" + m_kind + ">\n<AppendedData encoding=\"raw\">\n_",
                      end = "\n</AppendedData>\n</VTKFile>\n";
    Bytes file(begin.begin(), begin.end());
    file.insert(file.end(), m_bytes.begin(), m_bytes.end());
    file.insert(file.end(), end.begin(), end.end());
    return file;
}

} // namespace esm
