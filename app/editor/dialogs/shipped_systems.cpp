#include "app/editor/dialogs/shipped_systems.h"

#include "core/exchange/fuzzy/fuzzy_file.h"

#include <QObject>

#include <algorithm>

namespace esm {

const std::vector<std::shared_ptr<const FuzzySystem>>& shippedSystems() {
    static const auto systems = [] {
        std::vector<std::shared_ptr<const FuzzySystem>> read;
        for (const std::string& name : fuzzyPresetNames())
            read.push_back(std::make_shared<const FuzzySystem>(fuzzyPreset(name)));
        return read;
    }();
    return systems;
}

std::shared_ptr<const FuzzySystem> shippedSystem(const std::string& name) {
    const auto& systems = shippedSystems();
    const auto found = std::find_if(systems.begin(), systems.end(),
                                    [&](const auto& system) { return system->name == name; });
    return found == systems.end() ? nullptr : *found;
}

bool isShipped(const FuzzySystem& system) {
    const auto shipped = shippedSystem(system.name);
    if (!shipped) return false;
    FuzzySystem described = *shipped;
    described.description = system.description;
    described.note = system.note;
    return described == system;
}

QString shownName(const FuzzySystem& system) {
    const QString name = QString::fromStdString(system.name);
    return shippedSystem(system.name) && !isShipped(system) ? QObject::tr("%1 (changed)").arg(name) : name;
}

} // namespace esm
