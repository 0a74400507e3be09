#pragma once

#include "core/render/renderer.h"
#include "core/support/latest_input.h"

#include <QImage>
#include <QObject>
#include <QOffscreenSurface>
#include <QSurfaceFormat>
#include <QThread>

#include <memory>
#include <mutex>

namespace esm {

/// What a picture is made of.
struct PictureContent {
    RenderScene scene;
    Camera camera;
    PictureSize size;
};

struct MadePicture {
    int number = 0; ///< of the content that it shows, from 1
    QImage image;
    Camera camera;
    bool isSmooth = false; ///< its edges are, and no better picture of the same content follows
    QString problem;       ///< why there is no picture; empty when all is well
};

/// Draws pictures on a thread of its own, so that no organ, however large, and no slow graphics keep the
/// window waiting. The newest content wins. Where a picture with smooth edges takes long, as without a
/// graphics card, one without comes first, and the smooth one only once nothing newer waits.
class PictureMaker : public QObject {
    Q_OBJECT

public:
    explicit PictureMaker(QObject* parent = nullptr);
    ~PictureMaker() override;

    /// Gives the content's number.
    int ask(PictureContent content);
    /// The newest.
    MadePicture picture() const;

signals:
    void made();

private:
    struct Asked {
        PictureContent content;
        int number;
    };
    class Canvas;

    void work();
    void answer(Canvas& canvas, const Asked& asked);
    void publish(MadePicture picture);

    QOffscreenSurface m_surface; ///< made by the window's thread, which platforms ask for
    LatestInput<Asked> m_asked;
    int m_lastNumber = 0;
    mutable std::mutex m_mutex; ///< guards the picture
    MadePicture m_picture;
    std::unique_ptr<QThread> m_thread;
};

} // namespace esm
