#include "widgets/view/view_words.h"

#include "widgets/inputs/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace esm {

namespace {

struct ViewWords {
    Q_DECLARE_TR_FUNCTIONS(ViewWords)
};

} // namespace

QString sideWords(const Camera& camera) {
    const Eigen::Vector3d way = camera.eye - camera.target;
    int axis = 0;
    way.cwiseAbs().maxCoeff(&axis);
    const bool isPositive = way[axis] > 0;
    switch (axis) {
    case 0:
        return isPositive ? ViewWords::tr("seen from the right") : ViewWords::tr("seen from the left");
    case 1:
        return isPositive ? ViewWords::tr("seen from the top") : ViewWords::tr("seen from the bottom");
    default:
        return isPositive ? ViewWords::tr("seen from the front") : ViewWords::tr("seen from the back");
    }
}

QString legendWords(const ViewLegend& legend) {
    QStringList names;
    for (const ViewLegend::Entry& entry : legend.entries)
        names << entry.name;
    if (!names.isEmpty()) return legend.title + QStringLiteral(": ") + names.join(QStringLiteral(", "));
    return ViewWords::tr("%1 from %2 to %3 %4")
        .arg(legend.title, numberText(legend.minimum), numberText(legend.maximum), legend.unit);
}

} // namespace esm
