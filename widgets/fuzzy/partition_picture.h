#pragma once

#include "core/fuzzy/partition_edits.h"

#include <QFont>
#include <QPainter>
#include <QPalette>

#include <optional>
#include <vector>

namespace esm {

/// The colour of a term wherever it is drawn: from blue over violet to rose in the order of the terms,
/// readable on the palette's window.
QColor termColour(std::size_t term, std::size_t terms, const QPalette& palette);

/// What happens at a corner of a term: "begins at", "full from", "full to", "ends at".
QString cornerUse(Corner corner);

/// By how much an arrow key moves a corner: a round number, about a hundred and fiftieth of the range.
double cornerStep(const FuzzyVariable& variable);

/// What is drawn of a partition.
struct PartitionScene {
    FuzzyVariable variable;
    std::optional<double> value;
    std::size_t term = 0;         ///< the one in hand
    std::optional<Corner> corner; ///< of it, that the keys move
};

/// Where a variable's partition is drawn: names in one or two rows, the terms over the range, numbers
/// beneath.
class PartitionPicture {
public:
    PartitionPicture(const PartitionScene& scene, const QRect& place, const QFont& font);

    /// Where a degree over a value lies, pixels.
    QPointF placeOf(double value, double degree) const;
    QPointF placeOf(std::size_t term, Corner corner) const;
    double valueAt(double x) const;
    double valuePerPixel() const;
    /// The degree at a height, 0 to 1 and beyond.
    double degreeAt(double y) const;

    void paint(QPainter& painter, const QPalette& palette) const;
    /// The term whose name is there; none where there is no name.
    std::optional<std::size_t> nameAt(const QPointF& place) const;

    /// Rows of names that fit into a width: 1 or 2, whatever the terms' sets.
    static int nameRows(const FuzzyVariable& variable, int width, const QFont& font);

private:
    struct Name {
        std::size_t term;
        QRectF rect;
    };

    std::vector<Name> placedNames() const;
    void paintAxis(QPainter& painter, const QPalette& palette) const;
    void paintTerm(QPainter& painter, const QPalette& palette, std::size_t term) const;
    void paintNames(QPainter& painter, const QPalette& palette) const;
    void paintValue(QPainter& painter, const QPalette& palette) const;
    void paintDegree(QPainter& painter, const QPalette& palette, double degree, bool atRight) const;
    void paintCorners(QPainter& painter, const QPalette& palette) const;

    const PartitionScene& m_scene;
    QFontMetricsF m_metrics;
    QRectF m_place, m_plot;
};

} // namespace esm
