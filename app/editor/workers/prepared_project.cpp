#include "app/editor/workers/prepared_project.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

SimulationSettings settingsOf(const Project& project) {
    if (!project.stepping) return {};
    Stepping stepping = project.stepping->stepping;
    stepping.timeStep /= std::max(1.0, std::ceil(stepping.timeStep / longestWatchedStep));
    return withStepping({}, stepping);
}

/// @returns why there is no answer; empty when all is well
template<class Work> std::string failureOf(const Work& work) {
    try {
        work();
        return {};
    } catch (const std::exception& error) {
        return reasonOf(error);
    }
}

} // namespace

PreparedProject prepareProject(const Project& project, const TissueEvaluated& evaluated,
                               const std::shared_ptr<MatrixFactoriser>& factoriser) {
    PreparedProject prepared{project, nullptr, {}, {}, {}};
    prepared.failure =
        failureOf([&] { prepared.tissue = std::make_shared<const TissueModel>(evaluateModel(project)); });
    if (evaluated) evaluated(prepared.tissue);
    if (!prepared.tissue) return prepared;
    prepared.failure = failureOf([&] {
        prepared.gentlePull = gentlePull(*prepared.tissue);
        prepared.model = prepareModel(*prepared.tissue, settingsOf(project), factoriser);
        // The thread that steps goes on with one of its own.
        prepared.model->solvers.setFactoriser(std::make_shared<MatrixFactoriser>());
    });
    return prepared;
}

} // namespace esm
