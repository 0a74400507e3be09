#pragma once

#include "core/texture/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace esm {

/// Pixels.
struct TileSize {
    int width, height;

    bool operator==(const TileSize&) const = default;
};

/// A picture in tiles that never change. A picture that comes of another one shares all tiles with it that
/// are the same: it costs no more than what is new, and which tiles those are is told by where they lie in
/// memory.
class TiledImage {
public:
    /// Pixels in rows, as Image has them; also of what a tile has beyond the picture's end.
    using Tile = std::vector<std::uint8_t>;

    TiledImage() = default;
    /// Of one colour: one tile, shared by all places.
    TiledImage(int width, int height, TileSize tile, const std::array<std::uint8_t, 4>& colour);
    TiledImage(const Image& image, TileSize tile);

    int width() const { return m_width; }
    int height() const { return m_height; }
    bool empty() const { return m_tiles.empty(); }
    TileSize tileSize() const { return m_tile; }
    int columns() const { return (m_width + m_tile.width - 1) / m_tile.width; }
    int rows() const { return (m_height + m_tile.height - 1) / m_tile.height; }
    const Tile& tile(int column, int row) const { return *m_tiles[index(column, row)]; }
    const std::uint8_t* at(int x, int y) const;

    /// Whether another picture has the same size in as large tiles.
    bool isLike(const TiledImage& other) const {
        return m_width == other.m_width && m_height == other.m_height && m_tile == other.m_tile;
    }
    /// Precondition: the other is like this one.
    bool sharesTile(const TiledImage& other, int column, int row) const {
        return m_tiles[index(column, row)] == other.m_tiles[index(column, row)];
    }
    /// The same in one piece.
    Image image() const;

private:
    friend class TileRowPainter;

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(column);
    }

    int m_width = 0, m_height = 0;
    TileSize m_tile{1, 1};
    std::vector<std::shared_ptr<const Tile>> m_tiles; ///< row by row
};

/// Pixels that lie one behind the other in memory.
struct PixelRun {
    std::uint8_t* pixels;
    int count;
};

/// Paints into one row of a picture's tiles, each of which it replaces by a copy first. For one thread;
/// others may paint into other rows meanwhile.
class TileRowPainter {
public:
    /// @param image outlives the painter
    TileRowPainter(TiledImage& image, int row);

    /// Pixels of a row of the picture from x on, before `end`, as many as lie together.
    PixelRun run(int x, int end, int y);

private:
    TiledImage& m_image;
    int m_row;
    std::vector<TiledImage::Tile*> m_own; ///< of each column; null before anything was painted there
};

} // namespace esm
