#include "core/exchange/simulators/axial_difference.h"
#include "core/exchange/simulators/curved_hinges.h"
#include "core/exchange/simulators/look_differences.h"
#include "core/exchange/simulators/sofa/sofa_folder.h"
#include "core/exchange/simulators/sofa/sofa_scene.h"
#include "core/model/gentle_pull.h"
#include "core/support/numbers.h"

namespace esm {

namespace {

using DifferenceList = std::vector<Difference>;

void addTissueDifferences(const Handover& handover, const SofaRelease& release, DifferenceList& list) {
    const TissueModel& tissue = handover.tissue;
    if (tissue.stiffening && !release.knowsPullingSprings)
        list.push_back(
            {"before release 24.12 SOFA has one constant for a spring, however far it is stretched",
             "springs keep their first constant; write for 24.12 or later for both"});
    if (isCurvedAtRest(makeSpringSystem(tissue)))
        list.push_back({"SOFA has no hinges that are curved at rest",
                        "the wall's bending is that of springs which also resist being turned, by as much as "
                        "it is curved"});
}

void addDrawingDifferences(const Handover& handover, DifferenceList& list) {
    const Project& project = handover.project;
    const SpringNetwork& network = *handover.tissue.network;
    if (!project.mesh->triangles.empty() && !isDrawnInSofa(handover))
        list.push_back({"SOFA cannot lead a surface by a line", "the surface is left out"});
    if (network.binding && !network.lattice && isDrawnInSofa(handover))
        list.push_back({"SOFA draws a fine surface on the triangles of the coarse one that carries it",
                        "what stands out from these lies flat on them"});
    for (Difference& look : lookDifferences(project, "a scene of SOFA"))
        list.push_back(std::move(look));
}

/// What of a scene has no component in SOFA that does the same.
DifferenceList sceneDifferences(const Scene& scene) {
    DifferenceList list;
    if (!movesTissue(sceneInSofa(scene)))
        list.push_back({"nothing moves the organ in SOFA: its scene has no gravity, force or led node",
                        "it stands still there; record a pull and make it the scene (Measure, Poke), or use "
                        "esmc scene"});
    if (!scene.instruments.empty())
        list.push_back({"instruments of the scene are not handed over",
                        "nothing touches the organ; add instruments and collisions there"});
    if (!scene.splits.empty())
        list.push_back({"SOFA does not split the surface as the scene does", "it stays whole"});
    if (!scene.fillings.empty() || !scene.pressures.empty())
        list.push_back({"SOFA has no fluids and pressures over time within closed parts",
                        "nothing presses on their walls; a SurfacePressureForceField comes near"});
    return list;
}

std::string schemeOf(Damping damping) {
    return damping == Damping::Isotropic ? "SOFA's EulerImplicitSolver, solved by CGLinearSolver"
                                         : "SOFA's EulerExplicitSolver, symplectic";
}

/// Implicit Euler is stable then too, and damps all that happens between two steps.
std::string cautionFor(double timeStep, const Scene& scene) {
    constexpr double fewSteps = 10;
    if (timeStep * fewSteps <= scene.duration) return {};
    return "steps of " + timeInText(timeStep) + " are too few for a scene of " + timeInText(scene.duration);
}

} // namespace

Differences sofaDifferences(const Handover& handover, const HandoverMeans& means) {
    const auto& [timeStep, damping, version] = means.engine;
    Differences differences{.list = sceneDifferences(handover.project.scene), .scheme = schemeOf(damping)};
    addTissueDifferences(handover, releaseOf(version), differences.list);
    addDrawingDifferences(handover, differences.list);
    if (damping == Damping::Axial) differences.list.push_back(axialDifference());
    differences.largestStep = largestSofaStep(handover.tissue, damping, means.progress);
    differences.timeStep = timeStep.value_or(usualSofaStepFor(damping, differences.largestStep));
    differences.caution = cautionFor(differences.timeStep, handover.project.scene);
    return differences;
}

} // namespace esm
