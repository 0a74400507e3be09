#include "widgets/view/picture_maker.h"

#include "core/support/errors.h"
#include "core/support/thread_priority.h"

#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

namespace esm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int smoothSamples = 4; ///< per pixel
/// What a picture may take and still be made smooth at once: half a frame of a display.
constexpr std::chrono::milliseconds patience{8};
/// What a picture may take and still follow the hand.
constexpr std::chrono::milliseconds motionPatience{25};
/// A scene that did not change for so long is taken to rest. Frames of a slow motion come oftener.
constexpr std::chrono::milliseconds restTime{120};

/// Where a program draws in place of a graphics card, its threads, which this one starts, would else take
/// from the tissue the processors that it moves by: an edit is seen sooner, and as many pictures a second are
/// made. With 10, pictures come late while a slider is dragged.
constexpr int niceness = 5;

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

void* resolved(const char* name) {
    return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
}

} // namespace

/// The thread's own context and what is drawn on.
class PictureMaker::Canvas {
public:
    explicit Canvas(QOffscreenSurface& surface) : m_surface(surface) {}
    ~Canvas() {
        if (m_renderer) m_context.makeCurrent(&m_surface);
        m_target.reset();
        m_renderer.reset();
    }

    /// @throws std::runtime_error as paint()
    DrawnPicture draw(const PictureContent& content, int samples) {
        const Clock::time_point start = Clock::now();
        QImage image = paint(content, samples);
        return {std::move(image), Clock::now() - start};
    }

private:
    /// @throws std::runtime_error where OpenGL 3.3 is missing
    QImage paint(const PictureContent& content, int samples) {
        prepare();
        const QSize size(content.size.width, content.size.height);
        if (!m_target || m_target->size() != size || m_target->format().samples() != samples) {
            m_target.reset();
            QOpenGLFramebufferObjectFormat format;
            format.setSamples(samples);
            format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
            m_target.emplace(size, format);
        }
        if (!m_target->bind()) throw std::runtime_error("the graphics driver gives no picture of this size");
        m_renderer->draw(content.scene, content.camera, content.size);
        QImage image = m_target->toImage();
        image.reinterpretAsFormat(QImage::Format_RGB32); // nothing shines through the organ's background
        image.setDevicePixelRatio(content.size.pixelRatio);
        return image;
    }

    void prepare() {
        if (m_renderer) return;
        m_context.setFormat(surfaceFormat());
        if (!m_context.create() || !m_context.makeCurrent(&m_surface))
            throw std::runtime_error("the graphics driver has no OpenGL 3.3");
        m_renderer.emplace(resolved);
    }

    QOffscreenSurface& m_surface;
    QOpenGLContext m_context;
    std::optional<Renderer> m_renderer;
    std::optional<QOpenGLFramebufferObject> m_target;
};

PictureMaker::PictureMaker(PictureDrawing drawing, QObject* parent)
    : QObject(parent), m_drawing(std::move(drawing)), m_thread(QThread::create([this] { work(); })) {
    m_surface.setFormat(surfaceFormat());
    m_surface.create();
    m_thread->start();
}

PictureMaker::~PictureMaker() {
    m_asked.stop();
    m_thread->wait();
}

int PictureMaker::ask(PictureContent content) {
    m_asked.put({std::move(content), ++m_lastNumber});
    return m_lastNumber;
}

MadePicture PictureMaker::picture() const {
    const std::lock_guard lock(m_mutex);
    return m_picture;
}

/// What lives in the context is made and deleted by the thread that draws.
void PictureMaker::work() {
    giveWay(niceness);
    Canvas canvas(m_surface);
    const PictureDrawing draw =
        m_drawing ? m_drawing : [&canvas](const PictureContent& content, int samples) {
            return canvas.draw(content, samples);
        };
    while (const std::optional<Asked> asked = m_asked.take()) {
        try {
            answer(draw, *asked);
        } catch (const std::exception& problem) {
            publish(
                {asked->number, {}, asked->content.camera, true, QString::fromStdString(reasonOf(problem))});
        }
    }
}

DrawnPicture PictureMaker::drawn(const PictureDrawing& draw, const PictureContent& content, int samples) {
    DrawnPicture picture = draw(content, samples);
    m_isSlow = (samples > 0 ? picture.time : smoothSamples * picture.time) > patience;
    return picture;
}

/// Without smooth edges. A photo in motion has to follow the hand: a picture of a quarter of the pixels is
/// better than a whole one too late.
QImage PictureMaker::drawnQuickly(const PictureDrawing& draw, const PictureContent& content) {
    if (m_isVerySlow && content.scene.projectedPhoto) {
        PictureContent coarser = content;
        coarser.size = {std::max(1, content.size.width / 2), std::max(1, content.size.height / 2),
                        content.size.pixelRatio / 2, content.size.left / 2, content.size.bottom / 2};
        const DrawnPicture picture = drawn(draw, coarser, 0);
        m_isVerySlow = 4 * picture.time > motionPatience;
        // Enlarged once and here: the view paints it at every move of the mouse.
        QImage whole = picture.image.scaled(content.size.width, content.size.height, Qt::IgnoreAspectRatio,
                                            Qt::SmoothTransformation);
        whole.setDevicePixelRatio(content.size.pixelRatio);
        return whole;
    }
    DrawnPicture picture = drawn(draw, content, 0);
    m_isVerySlow = picture.time > motionPatience;
    return std::move(picture.image);
}

void PictureMaker::answer(const PictureDrawing& draw, const Asked& asked) {
    const auto& [content, number] = asked;
    if (m_isSlow) {
        publish({number, drawnQuickly(draw, content), content.camera, false, {}});
        if (m_asked.becomesObsoleteWithin(restTime)) return;
    }
    publish({number, drawn(draw, content, smoothSamples).image, content.camera, true, {}});
}

void PictureMaker::publish(MadePicture picture) {
    {
        const std::lock_guard lock(m_mutex);
        m_picture = std::move(picture);
    }
    emit made();
}

} // namespace esm
