#include "app/editor/workers/photo_preparer.h"

#include "core/support/errors.h"
#include "core/texture/layers/surface_match.h"
#include "core/texture/photo/region_growing.h"
#include "core/texture/photo/white_balance.h"
#include "widgets/texture/image_conversion.h"

#include <utility>

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

/// What was made last of a photo before its colours were adjusted, so that a slider of these is followed in
/// milliseconds whatever else is done to the photo.
class LastUnadjusted {
public:
    /// Fills in picture and share of highlights.
    /// @throws what prepared() throws
    void prepare(PreparedPhoto& result, const Progress& goOn) {
        const std::vector<std::string> problems = esm::validate(result.preparation.adjustment);
        if (!problems.empty()) throw InvalidModel(problems);
        PhotoPreparation wanted = result.preparation;
        const ColourAdjustment adjustment = std::exchange(wanted.adjustment, {});
        if (m_photo != result.photo || m_preparation != wanted) make(result.photo, wanted, goOn);
        result.highlightShare = m_highlightShare;
        result.picture = m_picture;
        if (adjustment != ColourAdjustment()) {
            Image adjusted = m_picture ? *m_picture : m_photo->image;
            adjustColours(adjusted, adjustment);
            result.picture = std::make_shared<const Image>(std::move(adjusted));
        }
    }

private:
    void make(const std::shared_ptr<const Photo>& photo, const PhotoPreparation& wanted,
              const Progress& goOn) {
        m_photo = nullptr; // nothing is known should it be cancelled
        m_picture = nullptr;
        if (!wanted.isNothing())
            m_picture = std::make_shared<const Image>(esm::prepared(photo->image, wanted, goOn));
        m_highlightShare = esm::highlightShare(photo->image, wanted);
        m_preparation = wanted;
        m_photo = photo;
    }

    std::shared_ptr<const Photo> m_photo;
    PhotoPreparation m_preparation;
    std::shared_ptr<const Image> m_picture; ///< null where the preparation does nothing
    double m_highlightShare = 0;
};

PreparedPhoto answerTo(const PreparationRequest& request, LastUnadjusted& last, const Progress& goOn) {
    const Image& photo = request.photo->image;
    PreparedPhoto result;
    result.photo = request.photo;
    result.preparation = withFound(request.preparation, photo, request.find);
    findPointedAt(request.find, photo, result.preparation);
    if (request.find.match) result.preparation.match = matched(request, result.preparation, goOn);
    if (request.known) {
        result.picture = request.known;
        result.highlightShare = highlightShare(photo, result.preparation);
    } else {
        last.prepare(result, goOn);
    }
    result.before = smaller(photo, smallPicture);
    result.after = result.picture ? smaller(*result.picture, smallPicture) : result.before;
    return result;
}

} // namespace

PhotoPreparer::PhotoPreparer(QObject* parent)
    : QObject(parent),
      m_worker([last = std::make_shared<LastUnadjusted>()](
                   const auto& task) { return answerTo(task.question, *last, task.progress()); },
               [this] { emit prepared(); }) {}

PreparedPhoto PhotoPreparer::result() const {
    const Outcome<PreparedPhoto> outcome = m_worker.outcome();
    PreparedPhoto result = outcome.failure.empty() ? outcome.answer : PreparedPhoto{};
    result.number = outcome.number;
    result.failure = QString::fromStdString(outcome.failure);
    return result;
}

} // namespace esm
