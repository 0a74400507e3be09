#include "core/texture/photo/photo_mask.h"

#include "core/texture/photo/stroke_cover.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace esm {

namespace {

/// A band of the photo is masked by all strokes before the next, so that what is kept of its pixels takes
/// little memory however large the photo is.
constexpr int rowsPerBand = 128;

/// What strokes keep of a band's pixels, 0 to 1.
class KeptBand {
public:
    explicit KeptBand(const PixelRange& band)
        : m_band(band),
          m_kept(static_cast<std::size_t>(band.width()) * static_cast<std::size_t>(band.height()), 1.0F) {}

    void lay(const PhotoStroke& stroke) {
        const StrokeCover cover = coverOf(stroke, m_band);
        const PixelRange& range = cover.range;
        for (int y = range.top; y <= range.bottom; ++y)
            for (int x = range.left; x <= range.right; ++x) {
                float& kept = m_kept[index(x, y)];
                const float covered = cover.at(x, y);
                kept = stroke.takesBack ? kept + (1 - kept) * covered : kept * (1 - covered);
            }
    }

    void mask(Image& photo) const {
        for (int y = m_band.top; y <= m_band.bottom; ++y)
            for (int x = m_band.left; x <= m_band.right; ++x) {
                std::uint8_t& alpha = photo.at(x, y)[3];
                alpha =
                    static_cast<std::uint8_t>(std::lround(static_cast<float>(alpha) * m_kept[index(x, y)]));
            }
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - m_band.top) * static_cast<std::size_t>(m_band.width()) +
               static_cast<std::size_t>(x);
    }

    PixelRange m_band; ///< of whole rows
    std::vector<float> m_kept;
};

} // namespace

void maskStrokes(Image& photo, const std::vector<PhotoStroke>& strokes) {
    if (photo.empty() || strokes.empty()) return;
    tbb::parallel_for(0, (photo.height + rowsPerBand - 1) / rowsPerBand, [&](int i) {
        const int top = i * rowsPerBand;
        KeptBand band({0, top, photo.width - 1, std::min(top + rowsPerBand, photo.height) - 1});
        for (const PhotoStroke& stroke : strokes)
            if (!stroke.path.empty()) band.lay(stroke);
        band.mask(photo);
    });
}

} // namespace esm
