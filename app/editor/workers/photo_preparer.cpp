#include "app/editor/workers/photo_preparer.h"

#include "core/texture/layers/surface_match.h"
#include "core/texture/photo/region_growing.h"
#include "core/texture/photo/white_balance.h"
#include "widgets/texture/image_conversion.h"

namespace esm {

namespace {

constexpr QSize smallPicture(280, 220); // pixels; twice what a panel shows, for dense screens

std::optional<ColourMatch> matched(const PreparationRequest& request, const PhotoPreparation& preparation,
                                   const Progress& progress) {
    if (!request.laid) return std::nullopt;
    const auto& [project, laid] = *request.laid;
    const std::size_t place = placeOf(project.layers, laid).value();
    TextureLayer layer = project.layers[place];
    layer.preparation = preparation;
    const std::vector<TextureLayer> beneath(project.layers.begin(),
                                            project.layers.begin() + static_cast<std::ptrdiff_t>(place));
    return matchToSurface(*project.mesh, beneath, project.texture.baseColour, layer, progress);
}

/// What is found from where the user points, in what the steps before leave of the photo.
void findPointedAt(const SoughtSteps& find, const Image& photo, PhotoPreparation& preparation) {
    if (find.region)
        for (PhotoStroke& stroke :
             growRegion(shownOf(photo, preparation), find.region->place, find.region->tolerance))
            preparation.strokes.push_back(std::move(stroke));
    if (find.whiteSpot)
        preparation.whiteBalance = whiteBalanceOfSpot(shownOf(photo, preparation), *find.whiteSpot);
    if (find.whiteLike)
        preparation.whiteBalance = whiteBalanceLike(shownOf(photo, preparation), *find.whiteLike);
}

PreparedPhoto answerTo(const PreparationRequest& request, const Progress& goOn) {
    const Image& photo = request.photo->image;
    PreparedPhoto result;
    result.photo = request.photo;
    result.preparation = withFound(request.preparation, photo, request.find);
    findPointedAt(request.find, photo, result.preparation);
    if (request.find.match) result.preparation.match = matched(request, result.preparation, goOn);
    result.picture = request.known;
    if (!result.picture && !result.preparation.isNothing())
        result.picture = std::make_shared<const Image>(esm::prepared(photo, result.preparation, goOn));
    result.highlightShare = highlightShare(photo, result.preparation);
    result.before = smaller(photo, smallPicture);
    result.after = result.picture ? smaller(*result.picture, smallPicture) : result.before;
    return result;
}

} // namespace

PhotoPreparer::PhotoPreparer(QObject* parent)
    : QObject(parent), m_worker([](const auto& task) { return answerTo(task.question, task.progress()); },
                                [this] { emit prepared(); }) {}

PreparedPhoto PhotoPreparer::result() const {
    const Outcome<PreparedPhoto> outcome = m_worker.outcome();
    PreparedPhoto result = outcome.failure.empty() ? outcome.answer : PreparedPhoto{};
    result.number = outcome.number;
    result.failure = QString::fromStdString(outcome.failure);
    return result;
}

} // namespace esm
