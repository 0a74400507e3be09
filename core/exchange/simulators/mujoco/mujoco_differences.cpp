#include "core/exchange/simulators/axial_difference.h"
#include "core/exchange/simulators/curved_hinges.h"
#include "core/exchange/simulators/look_differences.h"
#include "core/exchange/simulators/mujoco/mujoco_folder.h"
#include "core/exchange/simulators/mujoco/mujoco_subject.h"
#include "core/support/errors.h"
#include "core/support/numbers.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

std::string mujocoScheme(const MujocoStep& step) {
    const std::string scheme = "MuJoCo's semi-implicit Euler";
    return step.lag > 0 ? scheme + ", with armature for this step" : scheme;
}

using MujocoDifferences = std::vector<Difference>;

/// A tendon without length pulls along x.
bool hasSpringInOnePlace(const SpringSystem& system) {
    const std::vector<Eigen::Vector3d>& places = system.network->restPositions;
    return std::any_of(system.springs.begin(), system.springs.end(), [&](const auto& spring) {
        return spring.restLength > 0 && places[spring.first] == places[spring.second];
    });
}

void addMujocoTissue(const SpringSystem& system, MujocoDifferences& list) {
    const auto isBiphasic = [](const auto& spring) { return !spring.secondPhase.isLinear(); };
    if (std::any_of(system.springs.begin(), system.springs.end(), isBiphasic))
        list.push_back({"MuJoCo has one constant for a spring, however far it is stretched",
                        "a second spring beside each, slack up to the strain, makes it exact; such a model "
                        "needs MuJoCo 2.3.1 or later"});
    if (isCurvedAtRest(system))
        list.push_back(
            {"MuJoCo has no hinges that are curved at rest",
             "the wall's bending is that of weights which also resist being turned, by as much as it "
             "is curved"});
    if (hasSpringInOnePlace(system))
        list.push_back({"springs with a length whose ends lie in one place, which do nothing until they part",
                        "MuJoCo pushes their ends apart along the x axis"});
}

/// What of a scene no model of MuJoCo holds.
void addMujocoScene(const Scene& scene, MujocoDifferences& list) {
    if (!scene.forces.empty())
        list.push_back({"a model of MuJoCo holds no forces over time",
                        "they stand in its custom text 'scene', for your program to set xfrc_applied by"});
    if (!scene.moves.empty())
        list.push_back({"a model of MuJoCo holds no paths of led nodes",
                        "these are mocap bodies, for your program to lead by the custom text 'scene'; "
                        "viscosity does not feel their speed"});
    if (!scene.splits.empty()) list.push_back({"the scene's splits", "the surface stays whole"});
    if (!scene.fillings.empty() || !scene.pressures.empty())
        list.push_back({"fluids and pressures within closed parts", "nothing presses on their walls"});
    if (!scene.instruments.empty())
        list.push_back({"instruments of the scene are not handed over", "none are in the model"});
}

void addMujocoDrawing(const Handover& handover, MujocoDifferences& list) {
    const Project& project = handover.project;
    if (project.mesh->triangles.empty()) return;
    list.push_back({"MuJoCo's skins are drawn, and touch nothing",
                    "give the bodies of the nodes geoms where instruments are to push the organ"});
    const auto& binding = handover.tissue.network->binding;
    if (binding && (!binding->surface.empty() || !binding->lines.empty()))
        list.push_back(
            {"a body that only slides turns nothing that it carries",
             "the drawn surface follows its nodes' places, and does not turn with the tissue around "
             "them"});
    for (Difference& look : lookDifferences(project, "a model of MuJoCo"))
        list.push_back(std::move(look));
}

std::string lagText(double lag) {
    return std::isfinite(lag) ? "up to " + timeInText(lag)
                              : "without bound, since no viscosity holds the organ";
}

void addMujocoStep(const MujocoStep& step, MujocoDifferences& list) {
    if (step.lag > 0)
        list.push_back({"MuJoCo takes viscosity between nodes explicitly, which is stable up to steps of " +
                            timeInText(step.largestPlain),
                        "joints have armature for steps of " + timeInText(step.timeStep) +
                            ", by which slow motion comes later, " + lagText(step.lag)});
}

std::string cautionFor(const MujocoStep& step) {
    if (step.lag <= noticedMujocoLag) return {};
    return "slow motion comes later, " + lagText(step.lag) + ", with steps of " + timeInText(step.timeStep);
}

Differences toldOfMujoco(const Handover& handover, const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    const SpringSystem system = makeSpringSystem(handover.tissue);
    const MujocoSubject subject = mujocoSubject(handover, system, withProgress(means, parts.next(0.5)));
    Differences differences{.scheme = mujocoScheme(subject.step),
                            .timeStep = subject.step.timeStep,
                            .largestStep = largestStepOf(subject, parts.rest()),
                            .caution = cautionFor(subject.step)};
    addMujocoTissue(system, differences.list);
    if (subject.damping == Damping::Axial) differences.list.push_back(axialDifference());
    addMujocoStep(subject.step, differences.list);
    addMujocoScene(handover.project.scene, differences.list);
    addMujocoDrawing(handover, differences.list);
    return differences;
}

} // namespace

Differences mujocoDifferences(const Handover& handover, const HandoverMeans& means) {
    try {
        return toldOfMujoco(handover, means);
    } catch (const InvalidModel& error) {
        return {.refusal = error.what()};
    }
}

} // namespace esm
