#include "app/editor/document/step_subject.h"

namespace esm {

namespace {

template<class Part> struct Touched {
    const Part* only = nullptr;
    bool areSeveral = false;

    void add(const Part& part) {
        areSeveral = areSeveral || only;
        only = &part;
    }
};

/// As they are called after the edit, those that are gone as before it.
template<class Part>
Touched<Part> touchedParts(const std::vector<Part>& before, const std::vector<Part>& after) {
    Touched<Part> touched;
    for (const Part& part : after) {
        const Part* former = findPart(before, part.id);
        if (!former || !(*former == part)) touched.add(part);
    }
    for (const Part& part : before)
        if (!findPart(after, part.id)) touched.add(part);
    return touched;
}

} // namespace

QString stepSubject(const Project& before, const Project& after) {
    const auto regions = touchedParts(before.regions, after.regions);
    const auto layers = touchedParts(before.layers, after.layers);
    if (regions.areSeveral || layers.areSeveral || (regions.only && layers.only)) return {};
    if (regions.only) return QString::fromStdString(regions.only->name);
    return layers.only ? QString::fromStdString(layers.only->name) : QString();
}

} // namespace esm
