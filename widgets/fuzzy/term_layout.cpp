#include "widgets/fuzzy/term_layout.h"

#include <algorithm>
#include <cstddef>

namespace esm {

namespace {

/// Neighbours that touch and move as one.
struct WordGroup {
    std::size_t count;
    double wanted; ///< sum of where each of them would have the group begin

    double left() const { return wanted / static_cast<double>(count); }
};

} // namespace

/// Each word should stand over its place, none over another. The least squares of all shifts under that order
/// is isotonic regression, solved exactly in one pass by pooling adjacent violators (Ayer, Brunk, Ewing, Reid
/// and Silverman 1955): words that would overlap form a group, which goes to the mean of where its members
/// would have it. Pushing each word to the right of the one before would do too, but carry all the crowding
/// to the right end.
std::vector<double> spreadWords(const std::vector<PlacedWord>& words, double length, double gap) {
    // With the widths before it taken off every word is a point, and points in order need no gap.
    std::vector<double> before;
    double used = 0;
    for (const PlacedWord& word : words) {
        before.push_back(used);
        used += word.width + gap;
    }
    std::vector<WordGroup> groups;
    for (std::size_t i = 0; i < words.size(); ++i) {
        groups.push_back({1, words[i].middle - words[i].width / 2 - before[i]});
        while (groups.size() > 1 && groups[groups.size() - 2].left() > groups.back().left()) {
            const WordGroup last = groups.back();
            groups.pop_back();
            groups.back().count += last.count;
            groups.back().wanted += last.wanted;
        }
    }
    std::vector<double> lefts;
    for (const WordGroup& group : groups)
        for (std::size_t i = 0; i < group.count; ++i)
            lefts.push_back(std::clamp(group.left(), 0.0, std::max(0.0, length - (used - gap))) +
                            before[lefts.size()]);
    return lefts;
}

} // namespace esm
