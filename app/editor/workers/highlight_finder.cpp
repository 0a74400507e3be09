#include "app/editor/workers/highlight_finder.h"

namespace esm {

namespace {

constexpr QRgb marked = qRgba(0, 255, 160, 255); // a colour that no tissue has

QImage pictureOf(const PixelMask& mask, const Image& photo) {
    QImage picture(photo.width, photo.height, QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    for (int y = 0; y < photo.height && !mask.empty(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        const std::uint8_t* row = &mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(photo.width)];
        for (int x = 0; x < photo.width; ++x)
            if (row[x] != 0) line[x] = marked;
    }
    return picture;
}

} // namespace

HighlightFinder::HighlightFinder(QObject* parent)
    : QObject(parent),
      m_worker(
          [](const auto& task) {
              const auto& [photo, preparation] = task.question;
              return Found{photo, pictureOf(highlightsOf(photo->image, preparation), photo->image)};
          },
          [this] { emit found(); }) {}

void HighlightFinder::find(std::shared_ptr<const Photo> photo, const PhotoPreparation& preparation) {
    PhotoPreparation masking;
    masking.field = preparation.field;
    masking.strokes = preparation.strokes;
    masking.highlightThreshold = preparation.highlightThreshold;
    masking.highlightSensitivity = preparation.highlightSensitivity;
    m_worker.ask({std::move(photo), masking});
}

QImage HighlightFinder::maskOf(const std::shared_ptr<const Photo>& photo) const {
    const Found found = m_worker.outcome().answer;
    return photo && found.photo.lock() == photo ? found.mask : QImage();
}

} // namespace esm
