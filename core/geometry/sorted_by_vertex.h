#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace esm {

/// Sorts by `vertexOf(item)`, then by `isLess(one, other)` among those of one vertex. Items are counted into
/// their vertex's place, and only the few that share it are compared: time in proportion to the items and to
/// the largest vertex.
template<typename Item, typename VertexOf, typename IsLess>
std::vector<Item> sortedByVertex(const std::vector<Item>& items, const VertexOf& vertexOf,
                                 const IsLess& isLess) {
    std::vector<std::size_t> places(2, 0); // where those of a vertex begin, as soon as all are counted
    for (const Item& item : items) {
        const std::size_t next = std::size_t{vertexOf(item)} + 1;
        if (next >= places.size()) places.resize(next + 1, 0);
        ++places[next];
    }
    std::partial_sum(places.begin(), places.end(), places.begin());
    std::vector<Item> sorted(items.size());
    for (const Item& item : items)
        sorted[places[vertexOf(item)]++] = item;
    // Now each says where those of its vertex end.
    auto first = sorted.begin();
    for (const std::size_t place : places) {
        const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(place);
        std::sort(first, end, isLess);
        first = end;
    }
    return sorted;
}

/// For each edge, or triangle by its smallest vertex first, whether an equal one comes before it.
template<typename Item> std::vector<bool> repeats(const std::vector<Item>& items) {
    std::vector<std::size_t> numbers(items.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    const auto vertexOf = [&items](std::size_t i) { return std::get<0>(items[i]); };
    const auto isLess = [&items](std::size_t i, std::size_t j) {
        return items[i] != items[j] ? items[i] < items[j] : i < j;
    };
    numbers = sortedByVertex(numbers, vertexOf, isLess);
    std::vector<bool> isRepeated(items.size(), false);
    for (std::size_t i = 1; i < numbers.size(); ++i)
        isRepeated[numbers[i]] = items[numbers[i]] == items[numbers[i - 1]];
    return isRepeated;
}

} // namespace esm
