#include "core/model/integrators.h"

namespace esm {

namespace {

/// One row for each integrator, in the order of the enumeration. What a row leaves out is as most have it. A
/// table, and not a switch for each question: who adds an integrator sees in one place all that he has to
/// say, and the compiler finds a row that is missing.
///
/// Costs were measured on sks-liver-H07 (11 012 nodes) with two threads, and rounded up for slower machines.
/// They hold for lattices too: those of 2800 to 98 000 nodes, body-centred, took 0.3 to 1.3 times as much of
/// `split2` and 0.2 to 0.9 times of `bdf2`. A lattice's factor has more entries per node than a surface's,
/// but the lattice has as many more springs.
///
/// The order of each stands above its equations in core/dynamics/schemes, where its energy is kept in
/// core/dynamics/measure/energy_watch.
///
/// The first seven colours are those of Okabe and Ito (2008), made to be told apart by people who see few
/// colours. The five that follow are a grey and four that are darker than any of the seven: they differ in
/// lightness, which everybody sees.
constexpr std::array rows{
    IntegratorTraits{.integrator = Integrator::Auto,
                     .name = "auto",
                     .title = "chosen by the program",
                     .kind = StepKind::Open,
                     .order = 1,
                     .startsAs = Integrator::Auto,
                     .stepCost = 0,
                     .colour = {0, 0, 0},
                     .sentence = ""},
    IntegratorTraits{.integrator = Integrator::Euler,
                     .name = "euler",
                     .title = "explicit Euler",
                     .kind = StepKind::Explicit,
                     .order = 1,
                     .startsAs = Integrator::Euler,
                     .keptEnergy = KeptEnergy::InStepBefore,
                     .stepCost = 5e-9,
                     .colour = {230, 159, 0},
                     .sentence = "euler, the simplest method; it needs small steps"},
    IntegratorTraits{.integrator = Integrator::Verlet,
                     .name = "verlet",
                     .title = "Verlet",
                     .kind = StepKind::Explicit,
                     .order = 2,
                     .startsAs = Integrator::Verlet,
                     .keptEnergy = KeptEnergy::InStepAfter,
                     .stepCost = 1e-8,
                     .colour = {86, 180, 233},
                     .sentence = "verlet, a simple method of second order; it needs small steps"},
    IntegratorTraits{.integrator = Integrator::Heun,
                     .name = "heun",
                     .title = "Heun",
                     .kind = StepKind::Explicit,
                     .order = 2,
                     .startsAs = Integrator::Heun,
                     .stepCost = 1e-8,
                     .colour = {0, 158, 115},
                     .sentence = "heun, a method of second order; it needs small steps and some viscosity"},
    IntegratorTraits{.integrator = Integrator::Rk4,
                     .name = "rk4",
                     .title = "Runge-Kutta",
                     .kind = StepKind::Explicit,
                     .order = 4,
                     .startsAs = Integrator::Rk4,
                     .stepCost = 2e-8,
                     .colour = {240, 228, 66},
                     .sentence = "rk4, a very accurate method; it needs small steps"},
    IntegratorTraits{.integrator = Integrator::AdamsMoulton,
                     .name = "adams-moulton",
                     .title = "Adams-Moulton",
                     .kind = StepKind::Explicit,
                     .order = 4,
                     .startsAs = Integrator::Rk4,
                     .stepCost = 1.5e-8,
                     .colour = {0, 114, 178},
                     .sentence = "adams-moulton, a very accurate method; it needs very small steps"},
    IntegratorTraits{.integrator = Integrator::Propagation,
                     .name = "propagation",
                     .title = "force propagation",
                     .kind = StepKind::Searching,
                     .order = 1,
                     .startsAs = Integrator::Propagation,
                     .stepCost = 1e-5,
                     .colour = {213, 94, 0},
                     .sentence = "propagation, where forces settle node by node before the tissue moves on"},
    IntegratorTraits{.integrator = Integrator::Implicit,
                     .name = "implicit",
                     .title = "implicit Euler",
                     .kind = StepKind::Solving,
                     .order = 1,
                     .startsAs = Integrator::Implicit,
                     .stepCost = 4e-7,
                     .colour = {204, 121, 167},
                     .sentence = "implicit, a method that stays calm however stiff the tissue is, and calms "
                                 "its motion"},
    IntegratorTraits{.integrator = Integrator::Bdf2,
                     .name = "bdf2",
                     .title = "implicit, second order",
                     .kind = StepKind::Solving,
                     .order = 2,
                     .startsAs = Integrator::Implicit,
                     .stepCost = 4e-7,
                     .colour = {120, 120, 120},
                     .sentence =
                         "bdf2, a method of second order that stays calm however stiff the tissue is"},
    IntegratorTraits{.integrator = Integrator::Projective,
                     .name = "projective",
                     .title = "projective",
                     .kind = StepKind::Solving,
                     .order = 1,
                     .startsAs = Integrator::Projective,
                     .hasConstantMatrix = true,
                     .mayDampAxially = false,
                     .lagsWhereTissueTurns = true,
                     .stepCost = 8e-8,
                     .colour = {130, 60, 20},
                     .sentence = "projective, a fast method that lags behind where tissue turns; measure "
                                 "again for a better one"},
    IntegratorTraits{.integrator = Integrator::Split,
                     .name = "split",
                     .title = "viscous split",
                     .kind = StepKind::Solving,
                     .order = 1,
                     .startsAs = Integrator::Split,
                     .hasConstantMatrix = true,
                     .mayDampAxially = false,
                     .keptEnergy = KeptEnergy::InStepBefore,
                     .stepCost = 8e-8,
                     .colour = {90, 60, 180},
                     .sentence = "split, a method that stays calm however viscous the tissue is"},
    IntegratorTraits{.integrator = Integrator::Split2,
                     .name = "split2",
                     .title = "viscous split, second order",
                     .kind = StepKind::Solving,
                     .order = 2,
                     .startsAs = Integrator::Split,
                     .hasConstantMatrix = true,
                     .mayDampAxially = false,
                     .stepCost = 8e-8,
                     .colour = {20, 90, 40},
                     .sentence =
                         "split2, a method of second order that stays calm however viscous the tissue is"},
    IntegratorTraits{.integrator = Integrator::Trapezoid,
                     .name = "trapezoid",
                     .title = "trapezoid rule",
                     .kind = StepKind::Solving,
                     .order = 2,
                     .startsAs = Integrator::Implicit,
                     .mayDampAxially = false,
                     .stepCost = 4e-7,
                     .colour = {160, 0, 80},
                     .sentence =
                         "trapezoid, a method of second order that bears stiff tissue and lets it swing on"},
};

/// `traitsOf` looks a row up by its number, which therefore has to be its place.
constexpr bool isRowOf(std::size_t index, Integrator integrator) {
    return rows[index].integrator == integrator && static_cast<std::size_t>(integrator) == index;
}

/// Whether the rows are those of `Auto` and of all the others, each where its number says.
constexpr bool areComplete() {
    if (rows.size() != allIntegrators.size() + 1 || !isRowOf(0, Integrator::Auto)) return false;
    for (std::size_t i = 0; i < allIntegrators.size(); ++i)
        if (!isRowOf(i + 1, allIntegrators[i])) return false;
    return true;
}
static_assert(areComplete(), "an integrator has no row, or one in another place");

} // namespace

const IntegratorTraits& traitsOf(Integrator integrator) {
    return rows.at(static_cast<std::size_t>(integrator));
}

const char* integratorName(Integrator integrator) {
    return traitsOf(integrator).name;
}

std::optional<Integrator> integratorFromName(const std::string& name) {
    for (const IntegratorTraits& row : rows)
        if (name == row.name) return row.integrator;
    return std::nullopt;
}

std::string integratorNames() {
    std::string list;
    for (const IntegratorTraits& row : rows)
        list += (list.empty() ? "" : ", ") + std::string(row.name);
    return list;
}

int orderOf(Integrator integrator) {
    return traitsOf(integrator).order;
}

bool isExplicit(Integrator integrator) {
    return traitsOf(integrator).kind == StepKind::Explicit;
}

bool mayBeExplicit(Integrator integrator) {
    return integrator == Integrator::Auto || isExplicit(integrator);
}

bool hasConstantMatrix(Integrator integrator) {
    return traitsOf(integrator).hasConstantMatrix;
}

// Follows from other traits and is none itself: a row cannot contradict itself.
bool hasSecondOrderForm(Integrator integrator) {
    const IntegratorTraits& traits = traitsOf(integrator);
    return traits.kind == StepKind::Solving && traits.startsAs != integrator;
}

} // namespace esm
