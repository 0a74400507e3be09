#include "app/editor/workers/poke_motion.h"

#include "app/editor/workers/prepared_project.h"
#include "app/editor/workers/preview_run.h"
#include "core/support/errors.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

PokePicture pictureOf(const PreviewRun& run) {
    PokePicture picture{run.time(), {}, run.heldInstrument()};
    picture.positions.reserve(run.positions().size());
    for (const Eigen::Vector3d& position : run.positions())
        picture.positions.push_back(position.cast<float>());
    const PreviewStatus status = run.status();
    const std::optional<FeltTissue> felt = status.pull ? status.pull : status.instrument;
    if (felt) picture.force = felt->force;
    if (felt) picture.displacement = felt->displacement;
    return picture;
}

} // namespace

PokeMotion motionUnder(const Poke& poke, const Project& project, const Progress& progress) {
    PreviewRun run;
    PreparedProject prepared = prepareProject(project);
    if (!run.take(std::move(prepared))) throw InvalidModel(run.status().failure);
    const Poke carried = carriedOver(poke, project.network);
    PokeMotion motion{project, {pictureOf(run)}, {}};
    const auto count = static_cast<std::size_t>(std::lround(poke.duration * pokePicturesPerSecond));
    while (motion.pictures.size() <= count) {
        reportProgress(progress, static_cast<double>(motion.pictures.size()) / static_cast<double>(count));
        if (!run.follow(carried, static_cast<double>(motion.pictures.size()) / pokePicturesPerSecond)) {
            motion.failure = run.status().failure;
            break;
        }
        motion.pictures.push_back(pictureOf(run));
    }
    return motion;
}

int pictureNumberAt(double time) {
    constexpr double rounding = 1e-6; // of a picture
    return static_cast<int>(std::floor(time * pokePicturesPerSecond + rounding));
}

const PokePicture& pictureAt(const PokeMotion& motion, double time) {
    const int last = static_cast<int>(motion.pictures.size()) - 1;
    return motion.pictures[static_cast<std::size_t>(std::clamp(pictureNumberAt(time), 0, last))];
}

std::vector<Eigen::Vector3d> inDoubles(const std::vector<Eigen::Vector3f>& positions) {
    std::vector<Eigen::Vector3d> doubles;
    doubles.reserve(positions.size());
    for (const Eigen::Vector3f& position : positions)
        doubles.push_back(position.cast<double>());
    return doubles;
}

} // namespace esm
