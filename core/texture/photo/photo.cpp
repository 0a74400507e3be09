#include "core/texture/photo/photo.h"

#include "core/support/errors.h"
#include "core/texture/photo/photo_format.h"
#include "core/texture/texture_limits.h"

#include <new>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <fcntl.h>
#include <mutex>
#include <unistd.h>

namespace esm {

namespace {

constexpr std::uintmax_t mostBytes = 1'000'000'000;

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

/// Keeps standard error quiet while it lives. The libraries behind the decoder print there what they think of
/// a picture, past every handler that can be set from outside; what is wrong with it is said once, by an
/// exception.
class QuietErrors {
public:
    QuietErrors() : m_lock(mutex()), m_kept(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)) {
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (m_kept >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) ::close(nowhere);
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors() {
        if (m_kept < 0) return;
        ::dup2(m_kept, STDERR_FILENO);
        ::close(m_kept);
    }

private:
    static std::mutex& mutex() {
        static std::mutex mutex; // standard error is one for the whole process
        return mutex;
    }

    std::lock_guard<std::mutex> m_lock;
    int m_kept;
};

/// The picture turned and mirrored as its orientation says that it is to be shown.
cv::Mat upright(cv::Mat picture, int orientation) {
    const bool isMirrored = orientation == 2 || orientation == 4 || orientation == 5 || orientation == 7;
    if (orientation == 3 || orientation == 4) cv::rotate(picture, picture, cv::ROTATE_180);
    if (orientation == 5 || orientation == 6) cv::rotate(picture, picture, cv::ROTATE_90_CLOCKWISE);
    if (orientation == 7 || orientation == 8) cv::rotate(picture, picture, cv::ROTATE_90_COUNTERCLOCKWISE);
    if (isMirrored) cv::flip(picture, picture, 1);
    return picture;
}

/// Empty where the file cannot be decoded. @throws std::bad_alloc
cv::Mat decode(const Bytes& encoded, const PhotoFormat& format) {
    const QuietErrors quiet;
    // Only the colour mode turns a JPEG upright by its EXIF orientation; only the unchanged mode keeps alpha.
    const int mode = format.isJpeg ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED;
    try {
        return upright(toRgba(cv::imdecode(encoded, mode)), format.orientation);
    } catch (const cv::Exception& error) {
        if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
        return {};
    }
}

/// @param shown the file as messages name it
std::shared_ptr<const Photo> makePhoto(const std::filesystem::path& shown, std::string name, Bytes encoded) {
    const PhotoFormat format = inspectPhoto(encoded);
    if (!format.problem.empty()) throw FileError(shown, format.problem);
    if (format.width > texture_limits::mostPhotoPixels / format.height)
        throw FileError(shown, "is larger than 268 megapixels (" + std::to_string(format.width) + " × " +
                                   std::to_string(format.height) + "); scale it down");
    const cv::Mat rgba = decode(encoded, format);
    if (rgba.empty())
        throw FileError(shown,
                        "is damaged or of a rare kind and cannot be decoded; save it as PNG or JPEG again");
    auto photo = std::make_shared<Photo>();
    photo->fileName = std::move(name);
    photo->encoded = std::move(encoded);
    photo->image.width = rgba.cols;
    photo->image.height = rgba.rows;
    photo->image.pixels.assign(rgba.data, rgba.data + 4 * rgba.total());
    return photo;
}

} // namespace

std::shared_ptr<const Photo> loadPhoto(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored) &&
        std::filesystem::file_size(file, ignored) > mostBytes)
        throw FileError(file, "is larger than 1 GB; choose a photo");
    return makePhoto(file, file.filename().string(), readFile(file));
}

std::shared_ptr<const Photo> decodePhoto(std::string name, Bytes encoded) {
    const std::filesystem::path shown = name;
    return makePhoto(shown, std::move(name), std::move(encoded));
}

} // namespace esm
