#include "core/model/integrators.h"

namespace esm {

namespace {

constexpr std::array names{"auto",        "euler",    "verlet", "heun",       "rk4",   "adams-moulton",
                           "propagation", "implicit", "bdf2",   "projective", "split", "split2"};

} // namespace

const char* integratorName(Integrator integrator) {
    return names.at(static_cast<std::size_t>(integrator));
}

std::optional<Integrator> integratorFromName(const std::string& name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (name == names.at(i)) return static_cast<Integrator>(i);
    return std::nullopt;
}

std::string integratorNames() {
    std::string list;
    for (const char* name : names)
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

int orderOf(Integrator integrator) {
    switch (integrator) {
    case Integrator::Rk4:
    case Integrator::AdamsMoulton:
        return 4;
    case Integrator::Verlet:
    case Integrator::Heun:
    case Integrator::Bdf2:
    case Integrator::Split2:
        return 2;
    default:
        return 1;
    }
}

bool isExplicit(Integrator integrator) {
    switch (integrator) {
    case Integrator::Euler:
    case Integrator::Verlet:
    case Integrator::Heun:
    case Integrator::Rk4:
    case Integrator::AdamsMoulton:
        return true;
    default:
        return false;
    }
}

bool mayBeExplicit(Integrator integrator) {
    return integrator == Integrator::Auto || isExplicit(integrator);
}

bool hasConstantMatrix(Integrator integrator) {
    return integrator == Integrator::Projective || integrator == Integrator::Split ||
           integrator == Integrator::Split2;
}

bool hasSecondOrderForm(Integrator integrator) {
    return integrator == Integrator::Bdf2 || integrator == Integrator::Split2;
}

} // namespace esm
