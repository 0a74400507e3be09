#include "core/decoders/picture_decoders.h"

#include <csetjmp>
#include <cstdio>
#include <new>
#include <stdexcept>

#include <jerror.h>
#include <jpeglib.h>

namespace esm {

namespace {

/// libjpeg leaves by longjmp: everything with a destructor lives outside the functions that call it.
struct JpegReader {
    JpegReader() {
        info.err = jpeg_std_error(&errors);
        errors.error_exit = [](j_common_ptr info) {
            std::longjmp(static_cast<JpegReader*>(info->client_data)->escape, 1);
        };
        errors.output_message = [](j_common_ptr) {};
        info.client_data = this;
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&info); }

    [[noreturn]] void fail() const {
        if (errors.msg_code == JERR_OUT_OF_MEMORY) throw std::bad_alloc();
        throw std::runtime_error("damaged");
    }

    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    std::jmp_buf escape{};
};

bool isInked(const JpegReader& reader) {
    return reader.info.num_components == 4;
}

bool begin(JpegReader& reader, ByteView encoded) {
    if (setjmp(reader.escape)) return false;
    jpeg_create_decompress(&reader.info);
    jpeg_mem_src(&reader.info, encoded.data(), encoded.size());
    jpeg_read_header(&reader.info, TRUE);
    reader.info.out_color_space = isInked(reader) ? JCS_CMYK : JCS_EXT_RGBA;
    jpeg_start_decompress(&reader.info);
    return true;
}

bool readRows(JpegReader& reader, Image& image) {
    if (setjmp(reader.escape)) return false;
    while (reader.info.output_scanline < reader.info.output_height) {
        JSAMPROW row = image.at(0, static_cast<int>(reader.info.output_scanline));
        jpeg_read_scanlines(&reader.info, &row, 1);
    }
    jpeg_finish_decompress(&reader.info);
    return true;
}

/// Cyan, magenta, yellow and black, 255 without ink as printing programs write them, become colours: what an
/// ink lets through times what black lets through. The shift divides by 256 in place of 255, which makes
/// colours brighter by less than two levels.
void mixInks(Image& image) {
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        std::uint8_t* const pixel = &image.pixels[i];
        const int black = pixel[3];
        for (int channel = 0; channel < 3; ++channel)
            pixel[channel] = static_cast<std::uint8_t>(black - ((255 - pixel[channel]) * black >> 8));
        pixel[3] = 255;
    }
}

} // namespace

bool isJpeg(ByteView encoded) {
    return encoded.size() > 2 && encoded[0] == 0xff && encoded[1] == 0xd8 && encoded[2] == 0xff;
}

Image decodeJpeg(ByteView encoded) {
    JpegReader reader;
    if (!begin(reader, encoded)) reader.fail();
    Image image;
    image.width = static_cast<int>(reader.info.output_width);
    image.height = static_cast<int>(reader.info.output_height);
    image.pixels.resize(4 * std::size_t{reader.info.output_width} * reader.info.output_height);
    if (!readRows(reader, image)) reader.fail();
    if (isInked(reader)) mixInks(image);
    return image;
}

} // namespace esm
