#include "app/esmc/named_layer.h"

#include "app/esmc/report.h"
#include "core/support/joined.h"

namespace esm {

TextureLayer& layerNamed(Project& project, const std::string& name, LayersMeant meant) {
    TextureLayer* found = nullptr;
    std::vector<std::string> names;
    for (TextureLayer& layer : project.layers) {
        if (meant == LayersMeant::Photographs && !layer.photo) continue;
        names.push_back('"' + layer.name + '"');
        if (layer.name != name) continue;
        if (found)
            throw UsageError("--layer: several layers are called \"" + name + "\"; give them other names");
        found = &layer;
    }
    if (found) return *found;
    const std::string kind = meant == LayersMeant::Photographs ? "photograph" : "layer";
    if (names.empty()) throw UsageError("--layer: the project has no " + kind);
    throw UsageError("--layer: no " + kind + " is called \"" + name + "\"; there are " + joined(names, ", "));
}

} // namespace esm
