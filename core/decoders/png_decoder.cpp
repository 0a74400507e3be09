#include "core/decoders/picture_decoders.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>
#include <stdexcept>

#include <png.h>

namespace esm {

namespace {

/// libpng leaves by longjmp: everything with a destructor lives outside the functions that call it.
struct PngReader {
    explicit PngReader(ByteView encoded)
        : left(encoded.size()), next(encoded.data()),
          png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (!info) throw std::bad_alloc();
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

    std::size_t left; ///< bytes not read yet
    const std::uint8_t* next;
    png_structp png;
    png_infop info;
};

void readBytes(png_structp png, png_bytep data, png_size_t size) {
    PngReader& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > reader.left) png_error(png, "cut off");
    std::memcpy(data, reader.next, size);
    reader.next += size;
    reader.left -= size;
}

/// Asks for red, green, blue and alpha, 8 bits each. False where the header is damaged.
bool readHeader(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_set_read_fn(reader.png, &reader, readBytes);
    png_read_info(reader.png, reader.info);
    png_set_expand(reader.png);
    png_set_scale_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return true;
}

bool readRows(PngReader& reader, std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(reader.png))) return false;
    png_read_image(reader.png, rows.data());
    return true;
}

} // namespace

bool isPng(ByteView encoded) {
    return png_sig_cmp(encoded.data(), 0, std::min<std::size_t>(8, encoded.size())) == 0 &&
           encoded.size() > 8;
}

Image decodePng(ByteView encoded) {
    PngReader reader(encoded);
    if (!readHeader(reader)) throw std::runtime_error("damaged header");
    Image image;
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    const std::size_t rowBytes = png_get_rowbytes(reader.png, reader.info);
    if (rowBytes != 4 * static_cast<std::size_t>(image.width))
        throw std::runtime_error("unknown kind of pixels");
    image.pixels.resize(rowBytes * static_cast<std::size_t>(image.height));
    std::vector<png_bytep> rows;
    rows.reserve(static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y)
        rows.push_back(image.at(0, y));
    if (!readRows(reader, rows)) throw std::runtime_error("damaged pixels");
    return image;
}

} // namespace esm
