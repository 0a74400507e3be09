#include "app/editor/tools/tool_context.h"

#include "widgets/inputs/number_text.h"

namespace esm {

QString stillnessHint(const Preview& preview) {
    const PreviewStatus status = preview.status();
    if (status.playing) return {};
    return status.failure.empty() ? QObject::tr("Paused: {play} lets the tissue move again")
                                  : QObject::tr("The tissue does not move: the line at the bottom says why");
}

QString feltText(const FeltTissue& felt) {
    const bool isWeak = felt.force > 0 && felt.force < 0.1;
    const QString force = isWeak ? withUnit(1000 * felt.force, QStringLiteral("mN"), 2)
                                 : withUnit(felt.force, QStringLiteral("N"), 2);
    return QObject::tr("%1 · %2 mm").arg(force, decimalText(1000 * felt.displacement, 1));
}

QString missingLayer(const Selection& selection) {
    return selection.photo() ? QString() : QObject::tr("There is no photo yet: {addPhoto} adds one");
}

QString missingPhoto(const Selection& selection) {
    const TextureLayer* layer = selection.selectedLayer();
    const bool isPainted = layer && !layer->photo;
    return isPainted ? QObject::tr("The selected layer has no photo, it is painted")
                     : missingLayer(selection);
}

} // namespace esm
