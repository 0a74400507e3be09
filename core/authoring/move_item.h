#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace esm {

/// Whether an item of a list can go `by` places towards its end, or its beginning where `by` is below zero,
/// and no further towards the beginning than `lowest`.
inline bool canMoveItem(std::size_t size, std::size_t item, int by, std::size_t lowest = 0) {
    if (item < lowest || item >= size) return false;
    const auto place = static_cast<std::ptrdiff_t>(item) + by;
    return by != 0 && place >= static_cast<std::ptrdiff_t>(lowest) &&
           place < static_cast<std::ptrdiff_t>(size);
}

/// The items it passes make room. Precondition: `canMoveItem`.
template<typename Item> void moveItem(std::vector<Item>& items, std::size_t item, int by) {
    const auto from = items.begin() + static_cast<std::ptrdiff_t>(item);
    if (by > 0)
        std::rotate(from, from + 1, from + by + 1);
    else
        std::rotate(from + by, from, from + 1);
}

} // namespace esm
