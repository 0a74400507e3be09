#include "widgets/texture/image_conversion.h"

namespace esm {

QImage toQImage(const Image& image) {
    return QImage(image.pixels.data(), image.width, image.height, 4 * image.width, QImage::Format_RGBA8888)
        .copy();
}

QImage smaller(const Image& image, const QSize& size) {
    if (image.empty()) return {};
    const QImage whole(image.pixels.data(), image.width, image.height, 4 * image.width,
                       QImage::Format_RGBA8888);
    const QSize fitting = whole.size().scaled(size.boundedTo(whole.size()), Qt::KeepAspectRatio);
    return fitting == whole.size()
               ? whole.copy()
               : whole.scaled(fitting.expandedTo({1, 1}), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

QImage thumbnail(const Image& image, int side) {
    if (image.empty()) return {};
    const QImage whole(image.pixels.data(), image.width, image.height, 4 * image.width,
                       QImage::Format_RGBA8888);
    const int crop = qMin(image.width, image.height);
    const QRect square((image.width - crop) / 2, (image.height - crop) / 2, crop, crop);
    return whole.copy(square).scaled(side, side, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

} // namespace esm
