#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace {

/// Motion JPEG in AVI: OpenCV encodes that itself, and whatever plays films plays it.
constexpr int quality = 85; // of 100; more is seen in no picture of tissue

cv::VideoWriter filmOf(const std::string& file, double perSecond, const cv::Size& size) {
    cv::VideoWriter film(file, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), perSecond,
                         size);
    if (!film.isOpened()) throw std::runtime_error("the film cannot be written");
    film.set(cv::VIDEOWRITER_PROP_QUALITY, quality);
    return film;
}

/// Pictures of one size, numbered from 1.
void encode(const std::string& start, double count, double perSecond, const std::string& file) {
    cv::VideoWriter film;
    for (int number = 1; number <= count; ++number) {
        char ending[16];
        std::snprintf(ending, sizeof ending, "%04d.png", number);
        const cv::Mat picture = cv::imread(start + ending, cv::IMREAD_COLOR);
        if (picture.empty()) throw std::runtime_error(start + ending + " cannot be read");
        if (number == 1) film = filmOf(file, perSecond, picture.size());
        film.write(picture);
    }
    if (!film.isOpened()) throw std::runtime_error("there are no pictures");
}

double numberIn(std::string_view word) {
    double number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size() || !(number > 0))
        throw std::runtime_error("how many pictures, and how many a second, are numbers above 0");
    return number;
}

} // namespace

/// esm-film START COUNT PER_SECOND FILE: of the pictures START0001.png, START0002.png and so on.
int main(int wordCount, char** words) {
    try {
        if (wordCount != 5) throw std::runtime_error("started without START COUNT PER_SECOND FILE");
        encode(words[1], numberIn(words[2]), numberIn(words[3]), words[4]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
