#pragma once

#include "app/editor/workers/texture_composer.h"
#include "core/render/renderer.h"

#include <QTimer>

namespace esm {

/// While a projector moves, its photo is projected onto the organ by the renderer, over a texture that is
/// composed without it; once it rests, it is painted like all others.
class MovingPhoto : public QObject {
    Q_OBJECT

public:
    explicit MovingPhoto(TextureComposer& composer, QObject* parent = nullptr);

    /// Looks at what became of the photos, and has composed what is to be seen.
    void follow(const Project& project);
    /// What the renderer is to project; nothing while all lies in the texture.
    /// @param over what is shown of the composer
    std::optional<ProjectedPhoto> projected(const TextureComposer::Composed& over) const;
    std::optional<ProjectedPhoto> projected() const { return projected(m_composer.composition()); }
    /// Whether what is composed now is only what lies around the moving photo.
    bool isMoving() const { return m_layer && !m_isResting; }

signals:
    /// The projector rests, its photo is being painted.
    void rested();

private:
    void move(LayerId layer);
    void composeAround();
    void rest();
    void takeTexture();

    TextureComposer& m_composer;
    Project m_project;              ///< as it was last seen
    std::optional<LayerId> m_layer; ///< that is projected
    bool m_isResting = false;       ///< and about to be painted
    QTimer m_rest, m_bands;
};

/// The layer that differs in its projector, where nothing else does.
std::optional<LayerId> movedLayer(const std::vector<TextureLayer>& before,
                                  const std::vector<TextureLayer>& now);

} // namespace esm
