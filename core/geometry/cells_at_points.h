#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace esm {

/// Which triangles, or tetrahedra, meet at each point: one point's after the other's, each in their order.
struct CellsAtPoints {
    std::vector<std::uint32_t> starts; ///< where those of each point begin in `numbers`; then the end
    std::vector<std::uint32_t> numbers;

    template<typename Cell>
    CellsAtPoints(const std::vector<Cell>& cells, std::size_t pointCount) : starts(pointCount + 1, 0) {
        for (const Cell& cell : cells)
            for (const std::uint32_t point : cell)
                ++starts[point + 1];
        for (std::size_t i = 0; i < pointCount; ++i)
            starts[i + 1] += starts[i];
        numbers.resize(starts.back());
        std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
        for (std::uint32_t i = 0; i < cells.size(); ++i)
            for (const std::uint32_t point : cells[i])
                numbers[next[point]++] = i;
    }

    template<typename Visit> void forEachAt(std::uint32_t point, const Visit& visit) const {
        for (std::uint32_t i = starts[point]; i < starts[point + 1]; ++i)
            visit(numbers[i]);
    }
};

} // namespace esm
