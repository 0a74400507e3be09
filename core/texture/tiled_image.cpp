#include "core/texture/tiled_image.h"

#include <algorithm>

namespace esm {

TiledImage::TiledImage(int width, int height, TileSize tile, const std::array<std::uint8_t, 4>& colour)
    : m_width(width), m_height(height), m_tile(tile) {
    Tile pixels(4 * static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = colour[i % 4];
    m_tiles.assign(static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows()),
                   std::make_shared<const Tile>(std::move(pixels)));
}

TiledImage::TiledImage(const Image& image, TileSize tile)
    : TiledImage(image.width, image.height, tile, {0, 0, 0, 0}) {
    for (int row = 0; row < rows(); ++row) {
        TileRowPainter painter(*this, row);
        const int end = std::min(m_height, (row + 1) * tile.height);
        for (int y = row * tile.height; y < end; ++y)
            for (int x = 0; x < m_width;) {
                const PixelRun run = painter.run(x, m_width, y);
                std::copy_n(image.at(x, y), 4 * run.count, run.pixels);
                x += run.count;
            }
    }
}

const std::uint8_t* TiledImage::at(int x, int y) const {
    const int column = x / m_tile.width, row = y / m_tile.height;
    return tile(column, row).data() +
           std::size_t{4} *
               static_cast<std::size_t>((y - row * m_tile.height) * m_tile.width + x - column * m_tile.width);
}

Image TiledImage::image() const {
    Image image{m_width, m_height, {}};
    image.pixels.resize(4 * static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height));
    for (int y = 0; y < m_height; ++y)
        for (int x = 0; x < m_width; x += m_tile.width)
            std::copy_n(at(x, y), 4 * std::min(m_tile.width, m_width - x), image.at(x, y));
    return image;
}

TileRowPainter::TileRowPainter(TiledImage& image, int row)
    : m_image(image), m_row(row), m_own(static_cast<std::size_t>(image.columns()), nullptr) {}

PixelRun TileRowPainter::run(int x, int end, int y) {
    const TileSize size = m_image.m_tile;
    const int column = x / size.width;
    TiledImage::Tile*& own = m_own[static_cast<std::size_t>(column)];
    if (!own) {
        std::shared_ptr<const TiledImage::Tile>& place = m_image.m_tiles[m_image.index(column, m_row)];
        const auto copy = std::make_shared<TiledImage::Tile>(*place);
        own = copy.get();
        place = copy;
    }
    const int left = column * size.width;
    const int before = (y - m_row * size.height) * size.width + x - left;
    return {own->data() + std::size_t{4} * static_cast<std::size_t>(before),
            std::min(end, left + size.width) - x};
}

} // namespace esm
