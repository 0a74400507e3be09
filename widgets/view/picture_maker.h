#pragma once

#include "core/render/renderer.h"
#include "core/support/latest_input.h"

#include <QImage>
#include <QObject>
#include <QOffscreenSurface>
#include <QSurfaceFormat>
#include <QThread>

#include <chrono>
#include <functional>
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

/// A picture as it was drawn.
struct DrawnPicture {
    QImage image;
    std::chrono::steady_clock::duration time; ///< that drawing took
};

/// Draws a picture, on the maker's thread. What it throws is told as the reason why there is none.
/// @param samples per pixel; 0: edges are not smooth
using PictureDrawing = std::function<DrawnPicture(const PictureContent& content, int samples)>;

/// Draws pictures on a thread of its own, so that no organ, however large, and no slow graphics keep the
/// window waiting. The newest content wins. Where a picture with smooth edges takes long, as without a
/// graphics card, one without comes first, and the smooth one only once nothing newer waits. Where that takes
/// long too, a photo in motion is drawn with half of the pixels a side.
class PictureMaker : public QObject {
    Q_OBJECT

public:
    /// @param drawing by OpenGL where none is given
    explicit PictureMaker(PictureDrawing drawing = {}, QObject* parent = nullptr);
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
    void answer(const PictureDrawing& draw, const Asked& asked);
    DrawnPicture drawn(const PictureDrawing& draw, const PictureContent& content, int samples);
    QImage drawnQuickly(const PictureDrawing& draw, const PictureContent& content);
    void publish(MadePicture picture);

    PictureDrawing m_drawing;
    bool m_isSlow = false;       ///< the thread's own: a picture with smooth edges takes long
    bool m_isVerySlow = false;   ///< the same: one without takes too long for a photo in motion
    QOffscreenSurface m_surface; ///< made by the window's thread, which platforms ask for
    LatestInput<Asked> m_asked;
    int m_lastNumber = 0;
    mutable std::mutex m_mutex; ///< guards the picture
    MadePicture m_picture;
    std::unique_ptr<QThread> m_thread;
};

} // namespace esm
