#include "app/editor/dialogs/import_report.h"

#include "core/project/project.h"
#include "core/support/joined.h"
#include "widgets/inputs/number_text.h"

#include <QObject>

namespace esm {

namespace {

/// What an open surface means for the organ that is made of it; empty for a closed one.
QString massOfWall(const RepairReport& report) {
    if (report.isClosed()) return {};
    const QString wall = QObject::tr("%1 mm").arg(decimalText(usualWallThickness * 1000, 0));
    return report.boundaryEdges > 0
               ? QObject::tr("An open surface weighs as a wall %1 thick, not as a filled organ.").arg(wall)
               : QObject::tr("The surface has no clear inside: it weighs as a wall %1 thick.").arg(wall);
}

QString crossingLine(std::size_t pairs) {
    const QString meeting = pairs == 1 ? QObject::tr("1 pair of triangles meets")
                                       : QObject::tr("%1 pairs of triangles meet").arg(countText(pairs));
    return QObject::tr("The surface runs through itself: %1. A hollow organ moves all the same; a solid one "
                       "is filled where these places are small.")
        .arg(meeting);
}

} // namespace

QStringList reportLines(const ImportedSurface& surface) {
    QStringList lines;
    for (const auto& warning : surface.report.warnings)
        lines << QString::fromStdString(warning);
    if (surface.meetingPairs > 0) lines << crossingLine(surface.meetingPairs);
    const QString wall = massOfWall(surface.report);
    if (!wall.isEmpty()) lines << wall;
    if (lines.isEmpty()) lines << QObject::tr("The surface is sound: nothing had to be repaired.");
    if (surface.mesh->textureCoordinates.empty()) return lines;
    if (surface.coordinateProblems.empty())
        lines << QObject::tr(
            "It has texture coordinates (UVs) of its own: Layout, under Texture, can lay photos "
            "by them.");
    else
        lines << QObject::tr("It has texture coordinates (UVs), by which no photo can be laid: %1")
                     .arg(QString::fromStdString(joined(surface.coordinateProblems, "; ")));
    return lines;
}

} // namespace esm
