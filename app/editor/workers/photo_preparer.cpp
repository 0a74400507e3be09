#include "app/editor/workers/photo_preparer.h"

#include "core/texture/layers/surface_match.h"
#include "widgets/texture/image_conversion.h"

namespace esm {

namespace {

constexpr QSize smallPicture(280, 220); // pixels; twice what a panel shows, for dense screens

std::optional<ColourMatch> matched(const PreparationRequest& request, const PhotoPreparation& preparation,
                                   const Progress& progress) {
    if (!request.laid) return std::nullopt;
    const auto& [project, place] = *request.laid;
    TextureLayer layer = project.layers[place];
    layer.preparation = preparation;
    const std::vector<TextureLayer> beneath(project.layers.begin(),
                                            project.layers.begin() + static_cast<std::ptrdiff_t>(place));
    return matchToSurface(*project.mesh, beneath, project.texture.baseColour, layer, progress);
}

} // namespace

PhotoPreparer::PhotoPreparer(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

PhotoPreparer::~PhotoPreparer() {
    m_requests.stop();
    m_thread.join();
}

int PhotoPreparer::prepare(PreparationRequest request) {
    m_requests.put({std::move(request), ++m_asked});
    return m_asked;
}

PreparedPhoto PhotoPreparer::result() const {
    const std::lock_guard lock(m_mutex);
    return m_result;
}

void PhotoPreparer::work() {
    while (const auto asked = m_requests.take()) {
        PreparedPhoto result;
        try {
            result = answer(*asked);
        } catch (const Cancelled&) {
            continue; // another request waits
        } catch (const std::bad_alloc&) {
            result.failure = tr("there is not enough memory for it.");
        } catch (const std::exception& error) {
            result.failure = QString::fromStdString(error.what());
        }
        result.number = asked->number;
        {
            const std::lock_guard lock(m_mutex);
            m_result = std::move(result);
        }
        emit prepared();
    }
}

PreparedPhoto PhotoPreparer::answer(const Asked& asked) const {
    const auto goOn = [&](double) { return !m_requests.isObsolete(); };
    const PreparationRequest& request = asked.request;
    const Image& photo = request.photo->image;
    PreparedPhoto result;
    result.photo = request.photo;
    result.preparation = withFound(request.preparation, photo, request.find);
    if (request.find.match) result.preparation.match = matched(request, result.preparation, goOn);
    result.picture = request.known;
    if (!result.picture && !result.preparation.isNothing())
        result.picture = std::make_shared<const Image>(esm::prepared(photo, result.preparation, goOn));
    result.highlightShare = highlightShare(photo, result.preparation);
    result.before = smaller(photo, smallPicture);
    result.after = result.picture ? smaller(*result.picture, smallPicture) : result.before;
    return result;
}

} // namespace esm
