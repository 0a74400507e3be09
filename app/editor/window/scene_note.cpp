#include "app/editor/window/scene_note.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace esm {

namespace {

struct SceneNoteTexts {
    Q_DECLARE_TR_FUNCTIONS(SceneNote)
};

QStringList happenings(const Scene& scene) {
    QStringList said;
    if (!scene.forces.empty()) said << SceneNoteTexts::tr("At set times, forces act on nodes.");
    if (!scene.moves.empty()) said << SceneNoteTexts::tr("At set times, nodes are moved.");
    if (scene.instruments.size() == 1) said << SceneNoteTexts::tr("An instrument follows a path.");
    if (scene.instruments.size() > 1)
        said << SceneNoteTexts::tr("%1 instruments follow paths.").arg(scene.instruments.size());
    const auto changes = [](const PartPressure& pressure) { return !isConstant(pressure); };
    if (std::any_of(scene.pressures.begin(), scene.pressures.end(), changes))
        said << SceneNoteTexts::tr("At set times, pressures from within change.");
    if (!scene.splits.empty()) said << SceneNoteTexts::tr("At set times, the organ is split along edges.");
    return said;
}

} // namespace

SceneNote sceneNote(const Scene& scene) {
    QStringList said = happenings(scene);
    if (said.isEmpty()) return {};
    if (!scene.splits.empty()) {
        said.prepend(SceneNoteTexts::tr(
            "The project holds a scene that “esmc simulate” runs. The window does not play splits "
            "yet: it shows the whole organ, and what you do yourself."));
        return {SceneNoteTexts::tr("Has a scene with splits"), said.join('\n')};
    }
    said.prepend(SceneNoteTexts::tr(
        "The project holds a scene. Simulation → Play scene ({playScene}) plays it from rest; else the "
        "window shows what you do yourself. “esmc simulate” writes its motion and forces to files."));
    return {SceneNoteTexts::tr("Has a scene to play"), said.join('\n')};
}

} // namespace esm
