#pragma once

#include <QPainter>
#include <QPalette>
#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace esm {

/// How the mark of a landmark looks, in the photo as on the organ.
struct MarkLook {
    int number = 0; ///< as people count, from 1
    bool isDoubtful = false;
    bool isSelected = false;
};

struct PaintedMark {
    QPointF place;
    MarkLook look;
    bool isHidden = false; ///< behind other surface
};

/// Rings with their numbers beside them: amber where doubtful, faint where hidden.
void paintMarks(QPainter& painter, const std::vector<PaintedMark>& marks, const QPalette& palette);

/// Where their numbers stand: beside each ring, apart from other rings and numbers where that can be.
std::vector<QRectF> numberRooms(const std::vector<PaintedMark>& marks);

/// The number of the mark under the mouse, the nearest within reach.
std::optional<int> markAt(const std::vector<PaintedMark>& marks, const QPointF& place);

} // namespace esm
