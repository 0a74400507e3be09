#pragma once

#include "core/fuzzy/fuzzy_system.h"

#include <cstdint>
#include <string>
#include <vector>

namespace esm {

/// Values of a variable from one to another, with or without these two. One value where both are the same.
struct ValueRange {
    double from, to;
    bool includesFrom, includesTo;
};

/// "from 3 to 4 kPa", "above 3, up to 4 kPa", "exactly 3 kPa".
std::string inWords(const ValueRange& range, const std::string& unit = {});

/// Part of a variable's range in which every term holds fully, partly or not at all throughout: a corner
/// (`from` is `to`), or what lies between two neighbouring corners, without them.
struct ValueCell {
    double from, to;
};

/// The variable's range in cells, in rising order.
std::vector<ValueCell> cellsOf(const FuzzyVariable& variable);

/// Some of a variable's cells.
class CellSet {
public:
    explicit CellSet(std::size_t cells) : m_cells(cells), m_words((cells + 63) / 64) {}

    void add(std::size_t cell) { m_words[cell / 64] |= std::uint64_t(1) << (cell % 64); }
    bool contains(std::size_t cell) const { return m_words[cell / 64] >> (cell % 64) & 1; }
    bool isEmpty() const;
    bool isWhole() const;
    bool isWithin(const CellSet& other) const;
    bool meets(const CellSet& other) const;
    void unite(const CellSet& other);
    void intersect(const CellSet& other);
    bool operator==(const CellSet& other) const { return m_words == other.m_words; }

private:
    std::size_t m_cells;
    std::vector<std::uint64_t> m_words;
};

/// The cells that are in the set, neighbours together.
std::vector<ValueRange> rangesOf(const std::vector<ValueCell>& cells, const CellSet& set);

/// The cells in which a term holds to more than nothing, or fully.
CellSet supportOf(const Trapezoid& set, const std::vector<ValueCell>& cells);
CellSet coreOf(const Trapezoid& set, const std::vector<ValueCell>& cells);
CellSet complementOf(const CellSet& set, std::size_t cells);

/// Values within the variable's range that belong to none of its terms.
std::vector<ValueRange> partitionGaps(const FuzzyVariable& variable);

} // namespace esm
