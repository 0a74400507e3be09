#include "app/editor/edits/layer_edits.h"

#include "core/authoring/layers.h"

#include <QCoreApplication>

namespace esm {

namespace {

struct LayerTexts {
    Q_DECLARE_TR_FUNCTIONS(LayerTexts)
};

} // namespace

void showOrHide(Document& document, LayerId layer) {
    const TextureLayer* before = findPart(document.project().layers, layer);
    if (!before) return;
    const bool isShown = !before->visible;
    document.edit(isShown ? LayerTexts::tr("Show layer") : LayerTexts::tr("Hide layer"),
                  [&](Project& project) { partOf(project.layers, layer).visible = isShown; });
}

void duplicateLayer(Document& document, LayerId layer) {
    if (!findPart(document.project().layers, layer)) return;
    const LayerId copy = document.newLayerId();
    document.edit(LayerTexts::tr("Duplicate layer"),
                  [&](Project& project) { duplicateLayer(project, layer, copy); });
}

} // namespace esm
