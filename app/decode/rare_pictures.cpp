#include "app/decode/decoding_main.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <limits>

namespace {

using namespace esm;

/// Eight bits per channel, in red, green, blue, alpha. Empty for kinds of numbers that photos do not have.
cv::Mat toRgba(const cv::Mat& decoded) {
    cv::Mat eightBit = decoded;
    if (decoded.depth() == CV_16U) decoded.convertTo(eightBit, CV_8U, 255.0 / 65535.0);
    cv::Mat rgba;
    if (eightBit.depth() != CV_8U) return rgba;
    if (eightBit.channels() == 1) cv::cvtColor(eightBit, rgba, cv::COLOR_GRAY2RGBA);
    if (eightBit.channels() == 3) cv::cvtColor(eightBit, rgba, cv::COLOR_BGR2RGBA);
    if (eightBit.channels() == 4) cv::cvtColor(eightBit, rgba, cv::COLOR_BGRA2RGBA);
    return rgba;
}

/// Empty where the file cannot be decoded.
cv::Mat decodeRarePicture(std::span<const std::uint8_t> encoded) {
    if (encoded.size() > std::numeric_limits<int>::max()) return {};
    try {
        // A matrix cannot say that its numbers are not to be changed; imdecode() only reads them.
        const cv::Mat bytes(1, static_cast<int>(encoded.size()), CV_8U,
                            const_cast<std::uint8_t*>(encoded.data()));
        return toRgba(cv::imdecode(bytes, cv::IMREAD_UNCHANGED));
    } catch (const cv::Exception& error) {
        if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
        return {};
    }
}

void decode(char**, DecodedWriter& writer) {
    const cv::Mat rgba = decodeRarePicture(standardInput());
    if (rgba.empty()) throw std::runtime_error(undecodablePicture);
    writePicture(static_cast<std::uint32_t>(rgba.cols), static_cast<std::uint32_t>(rgba.rows), rgba.data,
                 writer);
}

} // namespace

/// As esm-decode, for rare kinds of TIFF and BMP.
int main(int wordCount, char** words) {
    ::_exit(esm::decodingMain(wordCount, words, decode));
}
