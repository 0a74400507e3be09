#include "app/editor/dialogs/inside_texts.h"

#include "app/editor/dialogs/body_work.h"
#include "app/editor/dialogs/thin_wall_text.h"
#include "core/project/wall.h"
#include "core/solid/prism_wall.h"
#include "widgets/inputs/number_text.h"

#include <QObject>
#include <QStringList>

#include <algorithm>

namespace esm {

namespace {

QString countsText(double nodes, double springs, double tetrahedra) {
    const auto count = [](double number) { return countText(static_cast<std::size_t>(number)); };
    return QObject::tr("%1 nodes, %2 springs, %3 tetrahedra")
        .arg(count(nodes), count(springs), count(tetrahedra));
}

/// Beside the organ as it would be hollow.
QString workText(LatticeKind kind, double nodes, std::size_t vertices) {
    const double work = (kind == LatticeKind::Prisms ? workOfPrisms : workOfSolid) * nodes /
                        static_cast<double>(std::max<std::size_t>(vertices, 1));
    return QObject::tr("A step of the motion takes about %1 × that of the hollow organ.")
        .arg(numberText(work, 1));
}

QString thinnerText(const WallFit& fit) {
    QString text;
    if (fit.thinner > 0) text = QObject::tr("There is not room for that everywhere: ") + thinWallText(fit);
    if (fit.leftOut == 1) text += QObject::tr(" There is no wall under 1 triangle.");
    if (fit.leftOut > 1)
        text += QObject::tr(" There is no wall under %1 triangles.").arg(countText(fit.leftOut));
    return text.trimmed();
}

QString crossingsText(const NarrowCrossings& crossings) {
    const QString across = numberText(1000 * crossings.width, 2);
    if (crossings.places == 1)
        return QObject::tr("The surface runs through itself in one place, %1 mm across. The lattice passes "
                           "over it.")
            .arg(across);
    return QObject::tr("The surface runs through itself in %1 places, %2 mm across at most. The lattice "
                       "passes over them.")
        .arg(countText(crossings.places), across);
}

} // namespace

QString aboutInside(const std::optional<LatticeKind>& kind) {
    if (!kind)
        return QObject::tr("Springs in the surface alone: a bag, which its tethers and fixed nodes hold in "
                           "form. Every vertex is a node.");
    switch (*kind) {
    case LatticeKind::Cubic:
        return QObject::tr("Cubes with the diagonals of their faces: as firm in every direction.");
    case LatticeKind::BodyCentred:
        return QObject::tr("Cubes with a node in the middle: as firm in every direction, and the fewest "
                           "springs.");
    case LatticeKind::Graded:
        return QObject::tr(
            "Body-centred, with wider cubes deep within: a fifth fewer nodes from some 20 000 on; with the "
            "usual spacing hardly any cube is deep enough.");
    case LatticeKind::Diamond:
        return QObject::tr("As in diamond, with second neighbours: firmer along some directions than "
                           "others, up to twice.");
    case LatticeKind::Prisms:
        return QObject::tr("A prism under each triangle, in layers: the organ stays hollow, may be open, and "
                           "its wall keeps its form.");
    case LatticeKind::BareDiamond:
        break;
    }
    return QObject::tr("Four neighbours alone: it resists being pressed together, but no shear. The "
                       "surface alone keeps its form.");
}

QString insideCost(const FoundInside& found, std::size_t vertices) {
    const LatticeKind kind = found.filling.kind;
    const QString memory = QObject::tr("%1 MB of memory while it is made.")
                               .arg(numberText(std::max(1.0, found.estimate.bytes / 1e6), 2));
    if (!found.network)
        return QObject::tr("About %1; %2")
                   .arg(countsText(found.estimate.nodes, found.estimate.springs, found.estimate.tetrahedra),
                        memory) +
               ' ' + workText(kind, found.estimate.nodes, vertices);
    const SpringNetwork& network = *found.network;
    const auto nodes = static_cast<double>(network.restPositions.size());
    return countsText(nodes, static_cast<double>(network.springs.size()),
                      static_cast<double>(network.lattice->tetrahedra.size())) +
           QStringLiteral("; ") + memory + ' ' + workText(kind, nodes, vertices);
}

QString insideFirmness(const Project& project, LatticeKind kind) {
    const double modulus = youngsModulusOfWall(project.base.springConstant, project.base.wallThickness);
    const QString text =
        kind == LatticeKind::Prisms
            ? QObject::tr("%1 N/m of the whole organ are then tissue of %2 kPa (Young's modulus; Poisson's "
                          "ratio is ⅓). A thicker wall of it is stiffer.")
        : kind == LatticeKind::BareDiamond
            ? QObject::tr("%1 N/m of the whole organ then resist being pressed together as tissue of %2 kPa "
                          "does (Young's modulus), however fine the lattice is, and shear not at all.")
            : QObject::tr("%1 N/m of the whole organ are then tissue of %2 kPa (Young's modulus; Poisson's "
                          "ratio is ¼), however fine the lattice is.");
    return text.arg(numberText(project.base.springConstant), numberText(modulus / 1000, 3));
}

QString insideNotice(const FoundInside& found, std::size_t triangles) {
    if (isWall(found.filling))
        return found.network
                   ? thinnerText(wallFitOf(found.network->restPositions, *found.network->lattice, triangles))
                   : QString();
    QStringList notices;
    if (found.estimate.spacing < 0.99 * found.filling.spacing)
        notices += QObject::tr("The organ is too thin for that: neighbours lie about %1 mm apart.")
                       .arg(numberText(1000 * found.estimate.spacing, 2));
    if (found.estimate.crossings.places > 0) notices += crossingsText(found.estimate.crossings);
    return notices.join(QLatin1Char(' '));
}

} // namespace esm
