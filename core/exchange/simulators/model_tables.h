#pragma once

#include "core/exchange/simulators/handover.h"

#include <string>
#include <variant>
#include <vector>

namespace esm {

/// What each thing in a table has: a number or a word, or as many numbers as there are parts.
struct TableColumn {
    std::string name;               ///< in small letters: "rest_length"
    std::string unit;               ///< "N·s/m"; empty where it has none
    std::vector<std::string> parts; ///< names of a row's numbers: "x", "y", "z"; empty: a row has one
    /// Row after row, the parts of a row side by side.
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::string>> values;
};

/// All things of one kind that an organ consists of.
struct ModelTable {
    std::string name; ///< "springs"
    std::vector<TableColumn> columns;
};

inline std::size_t partsOf(const TableColumn& column) {
    return column.parts.empty() ? 1 : column.parts.size();
}
std::size_t rowCount(const TableColumn& column);

/// The version of what `modelTables()` means: it rises where a reader of the one before would misread it.
inline constexpr int modelTablesVersion = 1;

/// All of an organ that moves, as plain tables in SI units, for formats that have no words of their own for
/// it. Things are numbered from 0 as in the project. Tables of things that the organ has none of are left
/// out; what each holds is listed in `docs/model-tables.md`.
std::vector<ModelTable> modelTables(const Handover& handover);

/// Of a node the last region that it belongs to by half or more; −1 without one.
std::vector<std::int32_t> regionsOfNodes(const SpringNetwork& network, const std::vector<Region>& regions);

} // namespace esm
