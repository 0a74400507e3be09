#include "tests/benchmarks/atlas_packing.h"
#ifdef ESM_HAS_BULLET
#include "tests/benchmarks/bullet.h"
#endif
#include "tests/benchmarks/critical_step.h"
#include "tests/benchmarks/explicit_step.h"
#ifdef ESM_HAS_FUZZYLITE
#include "tests/benchmarks/fuzzylite.h"
#endif
#include "tests/benchmarks/layer_composition.h"
#include "tests/benchmarks/local_poke.h"
#include "tests/benchmarks/slider_move.h"
#include "tests/benchmarks/solid_tissue.h"
#include "tests/benchmarks/stiff_tissue.h"

#include <string>

namespace {

std::vector<benchmarks::Ratio> (*const subjects[])(){
    benchmarks::registerExplicitStep,     benchmarks::registerLocalPoke,   benchmarks::registerStiffTissue,
    benchmarks::registerCriticalStep,     benchmarks::registerSliderMove,  benchmarks::registerAtlasPacking,
    benchmarks::registerLayerComposition, benchmarks::registerSolidTissue,
#ifdef ESM_HAS_BULLET
    benchmarks::registerBullet,
#endif
#ifdef ESM_HAS_FUZZYLITE
    benchmarks::registerFuzzylite,
#endif
};

} // namespace

int main(int argumentCount, char** argumentValues) {
    // What is compared is measured in turn: a machine that becomes slower meanwhile does so for both.
    std::string interleaved = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments(argumentValues, argumentValues + argumentCount);
    arguments.push_back(interleaved.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());

    std::vector<benchmarks::Ratio> ratios;
    for (const auto registerSubject : subjects)
        for (benchmarks::Ratio& ratio : registerSubject())
            ratios.push_back(std::move(ratio));
    benchmarks::RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.print(ratios);
    return 0;
}
