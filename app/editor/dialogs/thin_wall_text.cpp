#include "app/editor/dialogs/thin_wall_text.h"

#include "widgets/inputs/number_text.h"

#include <QObject>

namespace esm {

QString thinWallText(const WallFit& fit) {
    return QObject::tr("%1 of %2 vertices have a thinner wall than asked for, down to %3 mm.")
        .arg(countText(fit.thinner), countText(fit.places), numberText(1000 * fit.least, 2));
}

QString thinWallWarning(const Project& project) {
    const SpringNetwork& network = *project.network;
    if (!network.lattice || !isWall(network.lattice->filling)) return {};
    const WallFit fit = wallFitOf(network.restPositions, *network.lattice, project.mesh->triangles.size());
    return isOftenThinner(fit) ? thinWallText(fit) : QString();
}

} // namespace esm
