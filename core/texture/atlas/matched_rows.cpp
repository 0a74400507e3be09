#include "core/texture/atlas/matched_rows.h"

#include "core/texture/atlas/waiting_patches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace esm {

namespace {

/// Of the tallest that wait, how many are looked at. More fill rows better, at a price.
constexpr std::size_t mostCompared = 128;

/// Horizontal over vertical way of a patch's sides from the base to the third corner, both to the inside.
struct Slants {
    double first = 0, second = 0; ///< at the base's first and second corner

    /// A patch that points down unmirrored is turned by half a turn, which exchanges its slants; mirroring
    /// exchanges them too.
    double left(const PatchStance& stance) const {
        return stance.pointsUp == stance.isMirrored ? second : first;
    }
    double right(const PatchStance& stance) const {
        return stance.pointsUp == stance.isMirrored ? first : second;
    }
};

/// What of a patch is compared with others, side by side in memory.
struct Outline {
    double height, base; ///< m
    Slants slants;
};

Outline outlineOf(const PatchShape& shape) {
    if (!(shape.height > 0)) return {shape.height, shape.base, {}};
    return {shape.height, shape.base, {shape.foot / shape.height, (shape.base - shape.foot) / shape.height}};
}

/// Rows of one height waste room in two ways: above a patch that is less tall than its row, and between two
/// slants that do not run alike. The source's order, by height alone, keeps the first small and leaves the
/// second to chance. Here the next patch is the one of some that wait for which both together are least.
/// Greedy, as packing triangles best is NP-hard; on organs rows come within 7 % of what single triangles can
/// use at all (docs/performance.md).
class MatchedRowFiller {
public:
    MatchedRowFiller(const std::vector<PatchShape>& shapes, double scale, const PageRoom& page,
                     const Progress& progress)
        : m_shapes(shapes), m_progress(progress), m_scale(scale), m_gap(page.gap), m_stack(page),
          m_waiting(shapes.size()) {
        m_outlines.reserve(shapes.size());
        for (const PatchShape& shape : shapes)
            m_outlines.push_back(outlineOf(shape));
        m_layout.corners.resize(shapes.size());
        m_layout.page.resize(shapes.size());
    }

    PatchLayout fill() {
        while (!m_waiting.isEmpty()) {
            startRow();
            while (placeNext()) {
            }
        }
        reportProgress(m_progress, 1);
        m_layout.pages = m_stack.pages();
        m_layout.height = m_stack.totalHeight();
        return std::move(m_layout);
    }

private:
    struct Choice {
        std::uint32_t shape, link;
        PatchStance stance;
    };

    void startRow() {
        m_rowHeight = m_shapes[m_waiting.first()].height;
        m_stack.startRow(m_scale * m_rowHeight);
        m_row.clear();
        m_pointsUp = true;
        place({m_waiting.first(), 0, {true, false}}, m_stack.left());
    }

    bool placeNext() {
        if (m_waiting.isEmpty()) return false;
        const Choice best = bestMatch();
        if (const double x = placeOf(best); rightEndAt(best, x) <= m_stack.right()) {
            place(best, x);
            return true;
        }
        return placeLargestThatFits();
    }

    /// The one that leaves least of the row empty for its own area. As bases lie above and below in turn, a
    /// patch takes half of its base of the row's length; of (base / 2) · row height it leaves (base / 2) ·
    /// (row height − height), which is (row height − height) / height of its area. Slants that differ by d
    /// open a triangle of d · height² / 2 between two patches, which is d · height / base of it. Most
    /// candidates lose by so much that a product shows it: only the others are worth the divisions.
    Choice bestMatch() const {
        constexpr double surely = 1 + 1e-9; // beyond what rounding could turn around
        Choice best{m_waiting.first(), 0, {m_pointsUp, false}};
        double least = std::numeric_limits<double>::infinity();
        m_waiting.forFirst(mostCompared, [&](std::uint32_t i, std::uint32_t link) {
            const auto& [height, base, slants] = m_outlines[i];
            // Those that follow are less tall.
            if (m_rowHeight - height > surely * least * height) return false;
            for (const bool isMirrored : {false, true}) {
                const PatchStance stance{m_pointsUp, isMirrored};
                const double difference = std::abs(slants.left(stance) - m_slant);
                if (difference * height > surely * least * base) continue;
                const double tooLow = (m_rowHeight - height) / height, apart = difference * height / base;
                if (!(tooLow < least) || tooLow + apart >= least) continue;
                least = tooLow + apart;
                best = {i, link, stance};
            }
            return true;
        });
        return best;
    }

    /// At the end of a row, where the best match has no place: what counts there is to fill the rest, not to
    /// match.
    bool placeLargestThatFits() {
        std::optional<std::pair<Choice, double>> best;
        double largest = 0;
        m_waiting.forFirst(mostCompared, [&](std::uint32_t i, std::uint32_t link) {
            const double area = m_shapes[i].base * m_shapes[i].height;
            for (const bool isMirrored : {false, true}) {
                if (area <= largest) break;
                const Choice choice{i, link, {m_pointsUp, isMirrored}};
                const double x = placeOf(choice);
                if (rightEndAt(choice, x) > m_stack.right()) continue;
                largest = area;
                best = {choice, x};
            }
            return true;
        });
        if (best) place(best->first, best->second);
        return best.has_value();
    }

    PatchCorners cornersOf(const Choice& choice) const {
        return cornersInRow(m_shapes[choice.shape], m_scale, m_scale * m_rowHeight, choice.stance);
    }
    double placeOf(const Choice& choice) const {
        return m_row.shiftFor(cornersOf(choice), m_stack.left(), m_gap);
    }
    double rightEndAt(const Choice& choice, double x) const {
        return x + m_scale * m_shapes[choice.shape].base;
    }

    void place(const Choice& choice, double x) {
        PatchCorners corners = cornersOf(choice);
        shift(corners, x, 0);
        m_row.add(corners);
        shift(corners, 0, m_stack.top());
        m_layout.corners[choice.shape] = corners;
        m_layout.page[choice.shape] = m_stack.page();
        m_slant = m_outlines[choice.shape].slants.right(choice.stance);
        m_pointsUp = !m_pointsUp;
        m_waiting.take(choice.link);
        reportStep(m_progress, m_placed++, m_shapes.size());
    }

    const std::vector<PatchShape>& m_shapes;
    const Progress& m_progress;
    std::size_t m_placed = 0;
    std::vector<Outline> m_outlines;
    double m_scale, m_gap; ///< pixels per m, pixels
    RowStack m_stack;
    WaitingPatches m_waiting;
    double m_rowHeight = 0; ///< m
    double m_slant = 0;     ///< of the last patch's right side
    bool m_pointsUp = true;
    PatchRow m_row;
    PatchLayout m_layout;
};

} // namespace

PatchLayout layoutMatchedRows(const std::vector<PatchShape>& shapes, double texelsPerMetre,
                              const PageRoom& page, const Progress& progress) {
    if (!fitOnAPage(shapes, texelsPerMetre, page)) return {};
    return MatchedRowFiller(shapes, texelsPerMetre, page, progress).fill();
}

} // namespace esm
