#include "core/exchange/simulators/model_csv.h"

#include "core/exchange/charts/table_text.h"
#include "core/support/letters.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

/// "N·m·s/rad" is "_nms_per_rad": headings are words in any script's language.
std::string headingEnding(const std::string& unit) {
    if (unit.empty()) return "";
    std::string ending = "_";
    for (std::size_t i = 0; i < unit.size(); ++i)
        if (unit[i] == '/')
            ending += "_per_";
        else if (static_cast<unsigned char>(unit[i]) < 0x80) // the dot between units is none of ASCII
            ending += unit[i];
    return inSmallLetters(ending);
}

std::string headings(const ModelTable& table) {
    std::string line;
    for (const TableColumn& column : table.columns) {
        const std::string ending = headingEnding(column.unit);
        if (column.parts.empty()) line += column.name + ending + ',';
        for (const std::string& part : column.parts)
            line += part + ending + ',';
    }
    line.back() = '\n';
    return line;
}

std::string csvValue(double value) {
    return exactText(value);
}

std::string csvValue(std::int32_t value) {
    return std::to_string(value);
}

std::string csvValue(const std::string& value) {
    return quoted(value);
}

} // namespace

std::string csvOf(const ModelTable& table, const Progress& progress) {
    std::string text = headings(table);
    const std::size_t rows = rowCount(table.columns.front());
    for (std::size_t row = 0; row < rows; ++row) {
        for (const TableColumn& column : table.columns) {
            const std::size_t parts = partsOf(column);
            const auto addRow = [&](const auto& values) {
                for (std::size_t part = row * parts; part < (row + 1) * parts; ++part)
                    text += csvValue(values[part]) + ',';
            };
            std::visit(addRow, column.values);
        }
        text.back() = '\n';
        reportStep(progress, row, rows);
    }
    reportProgress(progress, 1);
    return text;
}

} // namespace esm
