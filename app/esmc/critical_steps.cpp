#include "app/esmc/critical_steps.h"

#include "core/support/joined.h"

#include <cmath>

namespace esm {

std::string stepInText(const std::optional<double>& step) {
    if (!step) return "none is stable";
    return std::isfinite(*step) ? inText(*step) + " s" : "no limit";
}

Json stepsInJson(const CriticalSteps& steps) {
    Json json;
    std::vector<std::string> notes;
    for (const auto& [integrator, step] : steps) {
        json[integratorName(integrator)] = inJson(step);
        if (!step || std::isinf(*step))
            notes.push_back(std::string(integratorName(integrator)) + ": " + stepInText(step));
    }
    json["note"] = joined(notes, "; ");
    return json;
}

} // namespace esm
