#include "core/exchange/image_file.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <limits>
#include <new>

#include <png.h>

namespace esm {

namespace {

/// libpng leaves by longjmp: everything with a destructor lives outside the function that calls it.
struct PngWriter {
    PngWriter()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (!info) throw std::bad_alloc();
    }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png, &info); }

    png_structp png;
    png_infop info;
};

void append(png_structp png, png_bytep data, png_size_t size) {
    Bytes& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
    bool full = false;
    try {
        bytes.insert(bytes.end(), data, data + size);
    } catch (const std::bad_alloc&) {
        full = true;
    }
    if (full) png_error(png, "out of memory");
}

template<typename Channel> bool isOpaque(const ImageOf<Channel>& image) {
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        if (image.pixels[i] != std::numeric_limits<Channel>::max()) return false;
    return true;
}

template<typename Channel>
void writeHeader(const PngWriter& writer, const ImageOf<Channel>& image, double texelsPerMetre, bool opaque) {
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8 * sizeof(Channel),
                 opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (texelsPerMetre > 0) {
        const auto density =
            static_cast<png_uint_32>(std::clamp(std::round(texelsPerMetre), 1.0, double(PNG_UINT_31_MAX)));
        png_set_pHYs(writer.png, writer.info, density, density, PNG_RESOLUTION_METER);
    }
    png_write_info(writer.png, writer.info);
    if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
    if (sizeof(Channel) > 1) png_set_swap(writer.png); // to PNG's order of bytes
}

template<typename Channel>
bool write(const PngWriter& writer, const ImageOf<Channel>& image, double texelsPerMetre, bool opaque,
           const Progress& progress) {
    if (setjmp(png_jmpbuf(writer.png))) return false;
    writeHeader(writer, image, texelsPerMetre, opaque);
    for (int y = 0; y < image.height; ++y) {
        reportProgress(progress, static_cast<double>(y) / image.height);
        png_write_row(writer.png, reinterpret_cast<png_const_bytep>(image.at(0, y)));
    }
    png_write_end(writer.png, writer.info);
    return true;
}

template<typename Channel>
Bytes encoded(const ImageOf<Channel>& image, double texelsPerMetre, const Progress& progress) {
    if (image.empty()) throw InvalidModel("a picture without pixels cannot be stored");
    Bytes bytes;
    PngWriter writer;
    png_set_write_fn(writer.png, &bytes, append, nullptr);
    if (!write(writer, image, texelsPerMetre, isOpaque(image), progress))
        throw InvalidModel("a picture of " + std::to_string(image.width) + " × " +
                           std::to_string(image.height) +
                           " pixels cannot be stored; there is too little memory, or it is too large");
    return bytes;
}

} // namespace

Bytes encodePng(const Image& image, double texelsPerMetre, const Progress& progress) {
    return encoded(image, texelsPerMetre, progress);
}

Bytes encodePng(const DeepImage& image, double texelsPerMetre) {
    return encoded(image, texelsPerMetre, {});
}

void writePng(const Image& image, const std::filesystem::path& file, double texelsPerMetre) {
    writeFileAtomically(file, encodePng(image, texelsPerMetre));
}

} // namespace esm
