#include "core/exchange/jpeg_file.h"

#include "core/support/errors.h"

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <jpeglib.h>

namespace esm {

namespace {

/// libjpeg leaves by longjmp: everything with a destructor lives outside the functions that call it.
struct JpegWriter {
    JpegWriter() {
        info.err = jpeg_std_error(&errors);
        errors.error_exit = [](j_common_ptr info) {
            std::longjmp(static_cast<JpegWriter*>(info->client_data)->escape, 1);
        };
        errors.output_message = [](j_common_ptr) {};
        info.client_data = this;
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;
    ~JpegWriter() {
        jpeg_destroy_compress(&info);
        std::free(content);
    }

    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    std::jmp_buf escape{};
    unsigned char* content = nullptr; ///< of libjpeg's, by malloc
    unsigned long size = 0;
};

/// Colours are stored as finely as brightness: half as fine, as is usual, one of their texels would reach
/// across a gap of two to the patch beside it.
void keepColoursFine(jpeg_compress_struct& info) {
    info.comp_info[0].h_samp_factor = 1;
    info.comp_info[0].v_samp_factor = 1;
}

/// JFIF knows dots per centimetre, 16 bits of them.
void noteTexelSize(jpeg_compress_struct& info, double texelsPerMetre) {
    const auto density = static_cast<UINT16>(std::clamp(std::round(texelsPerMetre / 100), 1.0, 65535.0));
    info.density_unit = 2;
    info.X_density = density;
    info.Y_density = density;
}

bool beginWriting(JpegWriter& writer, const Image& image, int quality, double texelsPerMetre) {
    if (setjmp(writer.escape)) return false;
    jpeg_create_compress(&writer.info);
    jpeg_mem_dest(&writer.info, &writer.content, &writer.size);
    writer.info.image_width = static_cast<JDIMENSION>(image.width);
    writer.info.image_height = static_cast<JDIMENSION>(image.height);
    writer.info.input_components = 4;
    writer.info.in_color_space = JCS_EXT_RGBX;
    jpeg_set_defaults(&writer.info);
    jpeg_set_quality(&writer.info, quality, TRUE);
    keepColoursFine(writer.info);
    writer.info.dct_method = JDCT_ISLOW; // the same on every machine
    if (texelsPerMetre > 0) noteTexelSize(writer.info, texelsPerMetre);
    jpeg_start_compress(&writer.info, TRUE);
    return true;
}

bool writeRow(JpegWriter& writer, const Image& image, int y) {
    if (setjmp(writer.escape)) return false;
    auto* row = const_cast<JSAMPROW>(image.at(0, y)); // libjpeg only reads it
    jpeg_write_scanlines(&writer.info, &row, 1);
    return true;
}

bool finishWriting(JpegWriter& writer) {
    if (setjmp(writer.escape)) return false;
    jpeg_finish_compress(&writer.info);
    return true;
}

void checkForJpeg(const Image& image, int quality) {
    if (image.empty()) throw InvalidModel("a picture without pixels cannot be stored");
    if (quality < leastJpegQuality || quality > mostJpegQuality)
        throw InvalidModel("the quality of a JPEG must be 1 to 100, not " + std::to_string(quality));
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        if (image.pixels[i] != 255)
            throw InvalidModel("a picture with transparent pixels cannot be a JPEG; store it as PNG");
}

bool writeRows(JpegWriter& writer, const Image& image, const Progress& progress) {
    for (int y = 0; y < image.height; ++y) {
        reportProgress(progress, static_cast<double>(y) / image.height);
        if (!writeRow(writer, image, y)) return false;
    }
    if (!finishWriting(writer)) return false;
    reportProgress(progress, 1);
    return true;
}

} // namespace

Bytes encodeJpeg(const Image& image, int quality, double texelsPerMetre, const Progress& progress) {
    checkForJpeg(image, quality);
    JpegWriter writer;
    if (!beginWriting(writer, image, quality, texelsPerMetre) || !writeRows(writer, image, progress))
        throw InvalidModel("a picture of " + std::to_string(image.width) + " × " +
                           std::to_string(image.height) +
                           " pixels cannot be stored as JPEG; there is too little memory, or it is larger "
                           "than 65500 pixels");
    return {writer.content, writer.content + writer.size};
}

} // namespace esm
