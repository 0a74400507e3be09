#include "app/editor/edits/input_edits.h"

#include <algorithm>

namespace esm {

namespace {

/// Among the inputs of the region's system.
std::size_t placeOfFirst(const Document& document, RegionId region, const NamedValues& inputs) {
    const auto& system = partOf(document.project().regions, region).system;
    if (!system) return 0;
    const auto first =
        std::find_if(system->inputs.begin(), system->inputs.end(),
                     [&](const FuzzyVariable& variable) { return variable.name == inputs.front().first; });
    return static_cast<std::size_t>(first - system->inputs.begin());
}

} // namespace

void editInputs(Document& document, RegionId region, const NamedValues& inputs) {
    QStringList names;
    for (const auto& input : inputs)
        names << QString::fromStdString(input.first).replace('_', ' ');
    if (names.isEmpty()) return;
    document.edit(QObject::tr("Set %1").arg(names.join(QObject::tr(" and "))),
                  [&](Project& project) {
                      for (const auto& [name, value] : inputs)
                          setInput(partOf(project.regions, region), name, value);
                  },
                  {inputs.size() > 1 ? EditKind::InputPair : EditKind::Input, region,
                   placeOfFirst(document, region, inputs)});
}

} // namespace esm
