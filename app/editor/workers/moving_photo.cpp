#include "app/editor/workers/moving_photo.h"

#include "app/editor/document/change.h"
#include "core/texture/layers/photo_in_motion.h"

#include <chrono>

namespace esm {

namespace {

/// Without an edit for so long, a projector rests.
constexpr std::chrono::milliseconds restTime{300};
/// What bands add changes slowly over the surface. Made for every move of the mouse, it would take the
/// processors that draw.
constexpr std::chrono::milliseconds betweenBands{100};

bool differsInProjector(TextureLayer before, const TextureLayer& now) {
    if (before.projector == now.projector) return false;
    before.projector = now.projector;
    return sameButForLandmarks(before, now);
}

} // namespace

std::optional<LayerId> movedLayer(const std::vector<TextureLayer>& before,
                                  const std::vector<TextureLayer>& now) {
    std::optional<LayerId> moved;
    if (before.size() != now.size()) return moved;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (sameButForLandmarks(before[i], now[i])) continue;
        if (moved || !differsInProjector(before[i], now[i])) return std::nullopt;
        moved = now[i].id;
    }
    return moved;
}

MovingPhoto::MovingPhoto(TextureComposer& composer, QObject* parent) : QObject(parent), m_composer(composer) {
    for (QTimer* timer : {&m_rest, &m_bands})
        timer->setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, &MovingPhoto::rest);
    connect(&m_bands, &QTimer::timeout, this, &MovingPhoto::composeAround);
    connect(&composer, &TextureComposer::composed, this, &MovingPhoto::takeTexture);
}

void MovingPhoto::follow(const Project& project) {
    const bool isSameTexture = project.mesh == m_project.mesh && project.atlas == m_project.atlas;
    const auto moved = isSameTexture ? movedLayer(m_project.layers, project.layers) : std::nullopt;
    m_project = project;
    const TextureLayer* layer = moved ? findPart(project.layers, *moved) : nullptr;
    if (layer && project.atlas && layer->photo && isShown(*layer)) return move(*moved);
    m_layer.reset();
    m_rest.stop();
    m_bands.stop();
    m_composer.compose(project);
}

void MovingPhoto::move(LayerId layer) {
    m_rest.start(restTime);
    const bool goesOn = m_layer == layer && !m_isResting;
    m_layer = layer;
    m_isResting = false;
    if (!goesOn) return composeAround();
    const bool isBanded = partOf(m_project.layers, layer).blending == Blending::MultiBand;
    if (isBanded && !m_bands.isActive()) m_bands.start(betweenBands);
}

void MovingPhoto::composeAround() {
    m_composer.compose(m_project, m_layer);
}

void MovingPhoto::rest() {
    m_bands.stop();
    m_isResting = true;
    m_composer.compose(m_project);
    emit rested();
}

void MovingPhoto::takeTexture() {
    if (m_isResting && !m_composer.isWorking()) m_layer.reset();
}

std::optional<ProjectedPhoto> MovingPhoto::projected(const TextureComposer::Composed& over) const {
    if (!m_layer) return std::nullopt;
    const TextureLayer& layer = partOf(m_project.layers, *m_layer);
    ProjectedPhoto projected{layer.projector, pictureOf(layer), borderInMotion(layer), layer.opacity,
                             layer.blending};
    projected.fadesAtMask = fadesAtMask(layer);
    if (over.moving != m_layer) return projected;
    projected.isMasked = over.isMasked;
    projected.bands = over.bands;
    return projected;
}

} // namespace esm
