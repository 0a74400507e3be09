#include "tests/support/made_photo.h"

#include "tests/support/made_field.h"
#include "tests/support/made_pale.h"
#include "tests/support/made_tissue.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace esm {

namespace {

/// All that a picture is made of before the camera sees it.
struct Parts {
    MadeField field;
    cv::Mat tissue, shine, pale;
    ColourGains cast;
    double cornerLevel = 0; ///< of 1
    double blur = 0;        ///< pixels
    cv::Mat noise;          ///< of 1
    cv::Mat overlay, overlayColours;
    int quality = 90; ///< of JPEG
};

ColourGains castOf(int variant, cv::RNG& random) {
    const auto any = [&](double from, double to) { return random.uniform(from, to); };
    switch (variant % 4) {
    case 0:
        return {any(0.97, 1.03), 1, any(0.97, 1.03)};
    case 1:
        return {any(0.78, 0.9), 1, any(1.1, 1.3)}; // bluish
    case 2:
        return {any(0.8, 0.9), 1, any(0.78, 0.92)}; // greenish
    default:
        return {any(1.08, 1.2), 1, any(0.7, 0.85)}; // warm
    }
}

/// What the camera's software writes over the picture.
class Overlays {
public:
    explicit Overlays(cv::Size size)
        : mask(cv::Mat::zeros(size, CV_8U)), colours(cv::Mat::zeros(size, CV_32FC3)) {}

    void write(const std::string& text, cv::Point at, const cv::Scalar& colour) {
        const double height = std::max(9.0, 0.028 * mask.rows);
        const double scale = height / 21;
        const int thickness = std::max(1, cvRound(height / 14));
        cv::putText(colours, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, colour, thickness, cv::LINE_8);
        cv::putText(mask, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, 255, thickness, cv::LINE_8);
    }
    void box(const cv::Rect& place, const cv::Scalar& colour) {
        cv::rectangle(colours, place, colour, cv::FILLED);
        cv::rectangle(mask, place, 255, cv::FILLED);
    }

    cv::Mat mask, colours;
};

void addOverlays(Parts& parts, int variant, cv::RNG& random) {
    const cv::Size size = parts.field.frame;
    Overlays overlays(size);
    const double w = size.width, h = size.height;
    const cv::Scalar white(0.95, 0.95, 0.95), yellow(0.95, 0.9, 0.2);
    const cv::Scalar colour = variant % 2 == 0 ? white : yellow;
    const int line = std::max(12, cvRound(0.045 * h));
    const cv::Point first(cvRound(0.015 * w), cvRound(random.uniform(0.06, 0.4) * h));
    if (variant % 3 != 2) {
        overlays.write("18/02/2013", first, colour);
        overlays.write("12:34:2" + std::to_string(variant), first + cv::Point(0, line), colour);
        overlays.write("CVP:5 A3", first + cv::Point(0, 2 * line), colour);
    }
    if (variant == 1 || variant == 4) {
        const cv::Rect box(0, cvRound(0.78 * h), cvRound(0.2 * w), size.height - cvRound(0.78 * h));
        overlays.box(box, cv::Scalar(0.06, 0.62, 0.5));
        overlays.write("8 E", box.tl() + cv::Point(box.width / 4, box.height / 2),
                       cv::Scalar(0.05, 0.3, 0.25));
    }
    if (variant == 3)
        overlays.box({cvRound(0.86 * w), cvRound(0.05 * h), cvRound(0.1 * w), cvRound(0.06 * h)},
                     cv::Scalar(0.5, 0.5, 0.5));
    parts.overlay = overlays.mask;
    parts.overlayColours = overlays.colours;
}

Parts partsOf(int index, std::uint64_t seed) {
    cv::RNG random(seed * 1000003 + static_cast<std::uint64_t>(index) * 7919 + 17);
    const int kind = index / 6, variant = index % 6;
    Parts parts;
    parts.field = madeField(kind, variant, random);
    const cv::Size size = parts.field.frame;
    parts.tissue = madeTissue(size, kind + variant, random);
    cv::RNG ofPale(seed * 1000003 + static_cast<std::uint64_t>(index) * 7919 + 18);
    const bool hasPale = (kind + variant) % 3 == 0; // a third of each kind
    parts.pale = hasPale ? addPaleObjects(parts.tissue, ofPale) : cv::Mat::zeros(size, CV_8U);
    lightUnevenly(parts.tissue, random);
    parts.shine = madeShine(size, random);
    if (hasPale) addFlecksOn(parts.pale, parts.shine, ofPale);
    parts.cast = castOf(kind + variant, random);
    parts.cornerLevel = variant % 2 == 0 ? 0 : random.uniform(5.0, 20.0) / 255;
    parts.blur = random.uniform(0.3, 1.1);
    parts.quality = random.uniform(78, 96);
    parts.noise.create(size, CV_32FC3);
    random.fill(parts.noise, cv::RNG::NORMAL, 0, random.uniform(0.8, 2.5) / 255);
    addOverlays(parts, variant, random);
    return parts;
}

Image imageOf(const cv::Mat& picture) {
    cv::Mat all;
    cv::cvtColor(picture, all, cv::COLOR_BGR2RGBA);
    return {all.cols, all.rows, {all.datastart, all.dataend}};
}

cv::Mat threeOf(const cv::Mat& one) {
    cv::Mat three;
    cv::merge(std::array<cv::Mat, 3>{one, one, one}.data(), 3, three);
    return three;
}

/// What meets the sensor, as it stores it, before noise. Mirror images add the lamp's light to the tissue's:
/// light adds up, and not what is stored of it.
cv::Mat seen(const Parts& parts, bool withShine, const ColourGains& gains) {
    constexpr double gamma = 2.2;
    cv::Mat light;
    cv::pow(parts.tissue, gamma, light);
    if (withShine) light += threeOf(parts.shine);
    cv::multiply(light,
                 cv::Scalar(std::pow(gains[0], gamma), std::pow(gains[1], gamma), std::pow(gains[2], gamma)),
                 light);
    cv::GaussianBlur(cv::min(light, 1.0), light, {}, parts.blur);
    cv::pow(light, 1 / gamma, light);
    const cv::Mat share = threeOf(parts.field.share);
    return light.mul(share) + parts.cornerLevel * (cv::Scalar::all(1) - share);
}

/// The picture as the camera stores it: with noise, what is written over it, and JPEG.
Image taken(const Parts& parts, const cv::Mat& light) {
    cv::Mat picture = light + parts.noise;
    parts.overlayColours.copyTo(picture, parts.overlay);
    cv::cvtColor(picture, picture, cv::COLOR_RGB2BGR);
    picture.convertTo(picture, CV_8U, 255);
    std::vector<std::uint8_t> file;
    cv::imencode(".jpg", picture, file, {cv::IMWRITE_JPEG_QUALITY, parts.quality});
    return imageOf(cv::imdecode(file, cv::IMREAD_COLOR));
}

/// The mean of the channels.
cv::Mat meanOf(const cv::Mat& colours) {
    cv::Mat mean;
    cv::transform(colours, mean, cv::Matx13f(1 / 3.0F, 1 / 3.0F, 1 / 3.0F));
    return mean;
}

} // namespace

MadePhoto madePhoto(int index, std::uint64_t seed) {
    const Parts parts = partsOf(index, seed);
    MadePhoto photo;
    photo.name = std::to_string(index) + " " + parts.field.name;
    const cv::Mat with = seen(parts, true, parts.cast), without = seen(parts, false, parts.cast);
    photo.image = taken(parts, with);
    photo.withoutFlecks = taken(parts, without);
    photo.balanced = taken(parts, seen(parts, true, {1, 1, 1}));
    photo.fillsFrame = cv::countNonZero(parts.field.mask == 0) == 0;
    photo.cast = parts.cast;
    photo.field = parts.field.mask;
    photo.overlays = parts.overlay;
    photo.pale = parts.pale;
    photo.shine = meanOf(with - without);
    return photo;
}

} // namespace esm
