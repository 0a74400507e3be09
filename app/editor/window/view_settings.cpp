#include "app/editor/window/view_settings.h"

namespace esm {

namespace {

const QString colouringKey = QStringLiteral("view/colourBy");

std::vector<std::pair<QString, QAction*>> switches(const Actions& a) {
    return {{QStringLiteral("view/surface"), a.showSurface},
            {QStringLiteral("view/wireframe"), a.showWireframe},
            {QStringLiteral("view/springs"), a.showSprings},
            {QStringLiteral("view/nodes"), a.showNodes},
            {QStringLiteral("view/regions"), a.showRegions},
            {QStringLiteral("view/projector"), a.showProjector},
            {QStringLiteral("view/orthographic"), a.orthographic},
            {QStringLiteral("view/endoscopeLight"), a.endoscopeLight}};
}

} // namespace

void saveView(QSettings& settings, const Actions& actions) {
    for (const auto& [key, action] : switches(actions))
        settings.setValue(key, action->isChecked());
    settings.setValue(colouringKey, actions.colourings->checkedAction()->objectName());
}

/// What a later version may have written and this one does not know stays as it is at first.
void restoreView(const QSettings& settings, const Actions& actions) {
    for (const auto& [key, action] : switches(actions))
        action->setChecked(settings.value(key, action->isChecked()).toBool());
    for (QAction* colouring : actions.colourings->actions())
        if (colouring->objectName() == settings.value(colouringKey).toString()) colouring->setChecked(true);
}

} // namespace esm
