#include "tests/growth/operations.h"

#include "core/dynamics/schemes/step_solver.h"
#include "core/dynamics/simulation.h"
#include "core/dynamics/stability/stability.h"
#include "core/exchange/project/project_file.h"

#include <ctime>
#include <fstream>
#include <utility>

namespace growth {

namespace {

using Words = std::vector<std::string>;

Operation command(const std::string& name, Words (*words)(const Files&)) {
    return {name,
            [words](const Files& files) {
                Words all{ESMC};
                for (std::string& word : words(files))
                    all.push_back(std::move(word));
                return run(all);
            },
            true};
}

double secondsOf(const std::function<void()>& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Tissue whose step has to be looked for, because stiffness and viscosity differ.
esm::TissueModel unevenTissue(const Files& files) {
    return esm::evaluateModel(esm::loadProject(files.uneven));
}

double setUp(const Files& files) {
    const esm::TissueModel tissue = unevenTissue(files);
    return secondsOf([&] {
        const esm::ChosenStep chosen = esm::chooseStep(tissue, {});
        esm::SimulationSettings withoutMatrix;
        withoutMatrix.integrator = esm::Integrator::Euler;
        withoutMatrix.timeStep = chosen.timeStep;
        const esm::Simulation simulation(tissue, withoutMatrix);
    });
}

double factorise(const Files& files) {
    const esm::SpringSystem system = esm::makeSpringSystem(unevenTissue(files));
    return secondsOf([&] {
        esm::MatrixFactoriser factoriser;
        const esm::StepMatrix matrix(system, esm::stepFactors(esm::Integrator::Split, 0.01, false),
                                     system.fixed, factoriser);
    });
}

Operation inMemory(const std::string& name, double (*seconds)(const Files&), bool isJudged) {
    const auto measure = [seconds](const Files& files) {
        const Outcome outcome = runApart([&] { return seconds(files); });
        return Usage{outcome.result, outcome.mebibytes};
    };
    return {name, measure, isJudged};
}

Words import(const Files& f) {
    return {"import", f.mesh, "-o", f.project};
}
Words otherTissue(const Files& f) {
    return {"tissue",     f.project,       "--ellipsoid", "0.1 0 0 0.1 0.1 0.1",
            "--override", "viscosity=0.5", "--override",  "spring_constant=40",
            "-o",         f.uneven};
}
Words info(const Files& f) {
    return {"info", f.uneven};
}
/// Next to nothing but its set-up.
Words simulate(const Files& f) {
    return {"simulate", f.uneven, "--scene", f.scene, "--integrator", "euler", "-o", f.trajectory};
}
Words pack(const Files& f) {
    return {"texture", "pack", f.project, "--size", "8192", "-o", f.packed};
}
Words package(const Files& f) {
    return {"export", f.uneven, "--to", "glb", "-o", f.package};
}
Words validateProject(const Files& f) {
    return {"validate", f.packed};
}
Words validatePackage(const Files& f) {
    return {"validate", f.package};
}

} // namespace

Files::Files(const TemporaryFolder& folder)
    : mesh(folder / "organ.ply"), scene(folder / "scene.json"), project(folder / "organ.esm"),
      uneven(folder / "uneven.esm"), packed(folder / "packed.esm"), package(folder / "organ.glb"),
      trajectory(folder / "trajectory.csv") {
    std::ofstream(scene) << R"({"duration": 1e-6, "record": {"every": 1}})";
}

std::vector<Operation> operations() {
    return {
        command("import", import),
        command("region of other tissue", otherTissue),
        command("info", info),
        command("simulate, one step", simulate),
        inMemory("of that, the set-up", setUp, true),
        inMemory("a factorisation, apart", factorise, false),
        command("texture pack", pack),
        command("export", package),
        command("validate, project", validateProject),
        command("validate, package", validatePackage),
    };
}

} // namespace growth
