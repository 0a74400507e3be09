#include "app/editor/edits/input_edits.h"

namespace esm {

void editInputs(Document& document, std::size_t region, const NamedValues& inputs) {
    QStringList names;
    for (const auto& input : inputs)
        names << QString::fromStdString(input.first).replace('_', ' ');
    if (names.isEmpty()) return;
    document.edit(
        QObject::tr("Set %1").arg(names.join(QObject::tr(" and "))),
        [&](Project& project) {
            for (const auto& [name, value] : inputs)
                setInput(project.regions[region], name, value);
        },
        QStringLiteral("input %1 %2").arg(region).arg(names.join(' ')));
}

} // namespace esm
