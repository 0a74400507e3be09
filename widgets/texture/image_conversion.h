#pragma once

#include "core/texture/image.h"

#include <QImage>

namespace esm {

/// A copy for drawing with Qt.
QImage toQImage(const Image& image);

/// A picture that fits into `size`, of the same proportions; never larger than the whole.
QImage smaller(const Image& image, const QSize& size);

/// A square that a picture fills, its longer side cropped.
QImage thumbnail(const Image& image, int side);

} // namespace esm
