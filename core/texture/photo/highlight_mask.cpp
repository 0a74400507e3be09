#include "core/texture/photo/highlight_fringes.h"
#include "core/texture/photo/highlights.h"
#include "core/texture/photo/photo_sampler.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// How much larger than 960 pixels a photo is: flecks grow with it.
double scaleOf(const cv::Size& size) {
    return std::max(1.0, std::max(size.width, size.height) / 960.0);
}

/// At which size surroundings are looked at, and how much shine is asked for there in relation to the
/// sensitivity: what is far away tells less of the tissue beneath a fleck.
struct Surrounding {
    double share; ///< of the photo's size at which it is computed
    int width;    ///< pixels there, of a window whose median is the surroundings' value
    double doubt;
};

/// Half of a window must show tissue: a fleck of 40 pixels needs one of 80 or so.
std::vector<Surrounding> surroundingsFor(const cv::Size& size) {
    const double large = scaleOf(size);
    return {{1 / (2 * large), 11, 1}, {1 / (4 * large), 17, 1.3}, {1 / (8 * large), 19, 2}};
}

/// Smaller by a share, but never without a pixel.
cv::Mat reducedBy(double share, const cv::Mat& picture) {
    const cv::Size size(cvRound(share * picture.cols), cvRound(share * picture.rows));
    cv::Mat reduced;
    if (size.empty())
        cv::resize(picture, reduced, {std::max(1, size.width), std::max(1, size.height)}, 0, 0,
                   cv::INTER_AREA);
    else
        cv::resize(picture, reduced, {}, share, share, cv::INTER_AREA);
    return reduced;
}

struct Brightness {
    cv::Mat darkest, middle, brightest, opaque; ///< channel, 8 bit; 255 where the photo has alpha
};

Brightness brightnessOf(const Image& photo) {
    const cv::Size size(photo.width, photo.height);
    Brightness brightness{cv::Mat(size, CV_8U), cv::Mat(size, CV_8U), cv::Mat(size, CV_8U),
                          cv::Mat(size, CV_8U)};
    tbb::parallel_for(0, photo.height, [&](int y) {
        for (int x = 0; x < photo.width; ++x) {
            const std::uint8_t* p = photo.at(x, y);
            const auto [least, most] = std::minmax({p[0], p[1], p[2]});
            const int middle = p[0] + p[1] + p[2] - least - most;
            brightness.darkest.at<std::uint8_t>(y, x) = p[3] > 0 ? least : 0;
            brightness.middle.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(p[3] > 0 ? middle : 0);
            brightness.brightest.at<std::uint8_t>(y, x) = p[3] > 0 ? most : 0;
            brightness.opaque.at<std::uint8_t>(y, x) = p[3] > 0 ? 255 : 0;
        }
    });
    return brightness;
}

/// What is transparent takes the mean of what is not around it, so that it does not count as dark tissue.
void fillTransparent(cv::Mat& channel, const cv::Mat& opaque, int width) {
    cv::Mat sum, weight, mean;
    const cv::Scalar all = cv::mean(channel, opaque > 0);
    channel.convertTo(sum, CV_32F);
    opaque.convertTo(weight, CV_32F, 1 / 255.0);
    sum = sum.mul(weight);
    cv::blur(sum, sum, {width, width});
    cv::blur(weight, weight, {width, width});
    cv::divide(sum + 0.001 * all[0], weight + 0.001, mean);
    mean.convertTo(mean, CV_8U);
    mean.copyTo(channel, opaque < 255);
}

/// The median around each pixel, of the photo's size.
cv::Mat medianAround(const cv::Mat& channel, const cv::Mat& opaque, const Surrounding& surrounding) {
    cv::Mat small = reducedBy(surrounding.share, channel);
    fillTransparent(small, reducedBy(surrounding.share, opaque), surrounding.width);
    cv::medianBlur(small, small, surrounding.width);
    cv::GaussianBlur(small, small, {}, 1.5);
    cv::resize(small, small, channel.size(), 0, 0, cv::INTER_LINEAR);
    return small;
}

/// How much white lies over a pixel's tissue, 0 to 255. Light D of tissue whose channels stand as q to 1,
/// with shine S over it, is q·D + S and D + S: S = (darkest − q·brightest) / (1 − q). Pale tissue, with q
/// near 1, tells little of it, and where a highlight is no brighter than its surroundings it is none: the
/// lesser of both is taken. What is much brighter counts whatever its colour: under a blue lamp shine is
/// blue.
double shineAt(int darkest, int brightest, int darkestAround, int brightestAround) {
    constexpr double muchBrighter = 30;
    const double brighter = darkest - darkestAround;
    if (brighter <= 0 || brightestAround == 0) return brighter;
    const double ratio = std::min(0.9, static_cast<double>(darkestAround) / brightestAround);
    const double paler = (darkest - ratio * brightest) / (1 - ratio);
    return std::max(brighter - muchBrighter, std::min(brighter, paler));
}

/// The greatest shine that any of the surroundings tells, float.
cv::Mat shineOf(const Brightness& brightness) {
    cv::Mat shine = cv::Mat::zeros(brightness.darkest.size(), CV_32F);
    for (const Surrounding& surrounding : surroundingsFor(shine.size())) {
        const cv::Mat darkest = medianAround(brightness.darkest, brightness.opaque, surrounding);
        const cv::Mat brightest = medianAround(brightness.brightest, brightness.opaque, surrounding);
        tbb::parallel_for(0, shine.rows, [&](int y) {
            for (int x = 0; x < shine.cols; ++x) {
                const double found = shineAt(
                    brightness.darkest.at<std::uint8_t>(y, x), brightness.brightest.at<std::uint8_t>(y, x),
                    darkest.at<std::uint8_t>(y, x), brightest.at<std::uint8_t>(y, x));
                float& most = shine.at<float>(y, x);
                most = std::max(most, static_cast<float>(found / surrounding.doubt));
            }
        });
    }
    return shine;
}

cv::Mat disk(double across) {
    const int width = 2 * cvRound(across / 2) + 1;
    return cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width});
}

/// The darkest channel of what is as pale around each pixel and wider than flecks are, above which flecks
/// stand: the opening of the photo by a disk (Serra 1982, Image Analysis and Mathematical Morphology: the
/// white top-hat). A polyp's paleness is its own level and hides none of the flecks upon it.
cv::Mat wideLevel(const Brightness& brightness) {
    constexpr double widest = 19.5, finer = 1.5; // pixels of a photo up to 960 wide
    const double share = 1 / (finer * scaleOf(brightness.darkest.size()));
    cv::Mat level = reducedBy(share, brightness.darkest);
    fillTransparent(level, reducedBy(share, brightness.opaque), 11);
    cv::medianBlur(level, level, 5); // pits and vessels do not part what is pale
    cv::morphologyEx(level, level, cv::MORPH_OPEN, disk(widest / finer));
    cv::dilate(level, level, cv::Mat::ones(3, 3, CV_8U)); // borders of what is pale are no thin flecks
    cv::resize(level, level, brightness.darkest.size(), 0, 0, cv::INTER_LINEAR);
    return level;
}

/// What is nearly white over more than the standing tells, and the soft edge around it. A lamp of any colour
/// leaves two channels near the end of their range. What is white over more than the largest flecks is a
/// pale organ near to the lamp.
cv::Mat widelyWhite(const Brightness& brightness, double level) {
    constexpr double narrowest = 12, widest = 36, edge = 8; // pixels of a photo up to 960 wide
    const double share = 1 / (2 * scaleOf(brightness.middle.size()));
    cv::Mat white, thick, wide;
    cv::addWeighted(brightness.middle, 0.5, brightness.brightest, 0.5, 0, white);
    white = reducedBy(share, white);
    cv::morphologyEx(white > level, thick, cv::MORPH_OPEN, disk(narrowest / 2));
    cv::morphologyEx(thick, wide, cv::MORPH_OPEN, disk(widest / 2));
    cv::dilate(wide, wide, disk(widest / 2));
    thick.setTo(0, wide);
    cv::dilate(thick, thick, disk(edge));
    cv::resize(thick, thick, brightness.middle.size(), 0, 0, cv::INTER_LINEAR);
    return thick > 127;
}

/// Shine without that of pale tissue. On a polyp, which is near to white itself, a white fleck stands little
/// above it and yet is one.
cv::Mat shineOfFlecks(const Brightness& brightness, double whiteLevel) {
    constexpr int white = 235, leastStanding = 20;
    constexpr float strong = 220;
    cv::Mat shine = shineOf(brightness);
    const cv::Mat level = wideLevel(brightness), isWhite = widelyWhite(brightness, whiteLevel);
    tbb::parallel_for(0, shine.rows, [&](int y) {
        for (int x = 0; x < shine.cols; ++x) {
            const int darkest = brightness.darkest.at<std::uint8_t>(y, x);
            const int standing = darkest - level.at<std::uint8_t>(y, x);
            float& value = shine.at<float>(y, x);
            if (isWhite.at<std::uint8_t>(y, x) == 0) value = std::min(value, static_cast<float>(standing));
            if (darkest > white && standing > leastStanding) value = strong;
        }
    });
    return shine;
}

/// Those parts of a mask that shine as much as is needed in a twelfth of their pixels. The larger a part, the
/// more is asked for: large mirror images are strong, and large faint ones nearly always pale tissue, or a
/// shaft of metal, which does not count for the one fleck that lies upon it.
cv::Mat strongParts(const cv::Mat& mask, const cv::Mat& shine, double needed) {
    constexpr int strongShare = 12;
    const int fewest = cvRound(2 * std::pow(scaleOf(mask.size()), 2)) - 1; // grain is smaller
    const double doubling = 30 * scaleOf(mask.size());                     // pixels across
    cv::Mat labels, boxes, middles;
    const int count = cv::connectedComponentsWithStats(mask, labels, boxes, middles);
    std::vector<double> neededOf(static_cast<std::size_t>(count));
    for (int label = 0; label < count; ++label)
        neededOf[static_cast<std::size_t>(label)] =
            needed * (1 + std::sqrt(boxes.at<int>(label, cv::CC_STAT_AREA)) / doubling);
    std::vector<int> strong(static_cast<std::size_t>(count), 0);
    for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x) {
            const auto label = static_cast<std::size_t>(labels.at<int>(y, x));
            strong[label] += shine.at<float>(y, x) > neededOf[label] ? 1 : 0;
        }
    std::vector<std::uint8_t> isKept(static_cast<std::size_t>(count), 0);
    for (int label = 1; label < count; ++label) {
        const int pixels = strong[static_cast<std::size_t>(label)];
        const bool isStrong =
            pixels >= fewest && strongShare * pixels >= boxes.at<int>(label, cv::CC_STAT_AREA);
        isKept[static_cast<std::size_t>(label)] = isStrong ? 255 : 0;
    }
    cv::Mat kept(mask.size(), CV_8U);
    tbb::parallel_for(0, mask.rows, [&](int y) {
        for (int x = 0; x < mask.cols; ++x)
            kept.at<std::uint8_t>(y, x) = isKept[static_cast<std::size_t>(labels.at<int>(y, x))];
    });
    return kept;
}

/// The strongest shine near each pixel, within what a large fleck's rim takes.
cv::Mat peaksOf(const cv::Mat& shine) {
    constexpr double reduced = 0.25;
    cv::Mat peaks = reducedBy(reduced, shine);
    cv::dilate(peaks, peaks, cv::Mat::ones(7, 7, CV_8U));
    cv::resize(peaks, peaks, shine.size(), 0, 0, cv::INTER_LINEAR);
    return peaks;
}

/// What surely shines, and what is fainter near to it.
cv::Mat rimsOf(const cv::Mat& shine, double needed) {
    constexpr double blur = 2; // pixels of a photo up to 960 wide
    const int reach = 2 * cvRound(blur * scaleOf(shine.size())) + 1;
    const auto least = static_cast<float>(std::max(8.0, 0.4 * needed));
    const cv::Mat peaks = peaksOf(shine);
    cv::Mat rims;
    cv::dilate(shine > needed, rims, cv::Mat::ones(reach, reach, CV_8U));
    tbb::parallel_for(0, shine.rows, [&](int y) {
        for (int x = 0; x < shine.cols; ++x) {
            const float value = shine.at<float>(y, x);
            if (value <= least || value <= 0.14F * peaks.at<float>(y, x)) rims.at<std::uint8_t>(y, x) = 0;
        }
    });
    return rims;
}

PixelMask pixelMaskOf(const cv::Mat& mask) {
    return {mask.datastart, mask.dataend};
}

/// The soft edge of a highlight, which the camera's optics and its compression leave, grows with the photo.
int rimFor(const cv::Mat& photo, int pixelsPerRim) {
    return std::max(2, std::max(photo.cols, photo.rows) / pixelsPerRim);
}

/// With a rim of so many pixels around it, where the photo has alpha.
cv::Mat withRim(const cv::Mat& mask, const cv::Mat& opaque, int rim) {
    cv::Mat wider;
    cv::dilate(mask, wider, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * rim + 1, 2 * rim + 1}));
    cv::bitwise_and(wider, opaque, wider);
    return wider;
}

PixelMask flecksOf(const Image& photo, double sensitivity) {
    constexpr double mostNeeded = 68, leastNeeded = 10;
    const double needed = mostNeeded * std::pow(leastNeeded / mostNeeded, sensitivity);
    const Brightness brightness = brightnessOf(photo);
    const cv::Mat shine = shineOfFlecks(brightness, 250 - 40 * sensitivity);
    const cv::Mat rims = rimsOf(shine, needed);
    cv::Mat flecks = withRim(strongParts(rims, shine, needed), brightness.opaque, rimFor(shine, 640));
    addFringes(flecks, photo, rimFor(shine, 160));
    return pixelMaskOf(flecks);
}

/// As large as it is looked at, whatever its size: halving would leave as little as half of that.
Image copyToLookAt(const Image& photo) {
    const double share = static_cast<double>(longestLookedAt) / std::max(photo.width, photo.height);
    const cv::Mat whole(photo.height, photo.width, CV_8UC4, const_cast<std::uint8_t*>(photo.pixels.data()));
    const cv::Mat reduced = reducedBy(share, whole);
    return {reduced.cols, reduced.rows, {reduced.datastart, reduced.dataend}};
}

/// Of a photo, from the mask of the smaller one.
PixelMask maskOfWhole(PixelMask small, const cv::Size& size, const Image& photo) {
    const cv::Mat mask(size, CV_8U, small.data());
    cv::Mat whole;
    cv::resize(mask, whole, {photo.width, photo.height}, 0, 0, cv::INTER_LINEAR);
    tbb::parallel_for(0, whole.rows, [&](int y) {
        for (int x = 0; x < whole.cols; ++x) {
            std::uint8_t& value = whole.at<std::uint8_t>(y, x);
            value = value > 127 && photo.at(x, y)[3] > 0 ? 255 : 0;
        }
    });
    return pixelMaskOf(whole);
}

} // namespace

/// Shine is white over the tissue's own colour, whatever its brightness: it is measured against the median of
/// what surrounds a pixel at three sizes, which passes over flecks that are smaller than half of the window
/// (after Arnold et al. 2010, Automatic segmentation and inpainting of specular highlights for endoscopic
/// imaging, where a median's colours are compared as well). A pale polyp in red tissue is told from a fleck
/// by its width: but for what is white, shine is only what stands above all that is as wide. From pixels that
/// surely shine the mask goes on to fainter ones joined to them (hysteresis, Canny 1986), as far as optics
/// and compression blur.
PixelMask highlightMask(const Image& photo, double sensitivity) {
    if (photo.empty()) return {};
    if (std::max(photo.width, photo.height) <= longestLookedAt) return flecksOf(photo, sensitivity);
    const Image small = copyToLookAt(photo);
    return maskOfWhole(flecksOf(small, sensitivity), {small.width, small.height}, photo);
}

PixelMask highlightsAbove(const Image& photo, int threshold) {
    if (photo.empty()) return {};
    const Brightness brightness = brightnessOf(photo);
    return pixelMaskOf(
        withRim(brightness.darkest > threshold, brightness.opaque, rimFor(brightness.darkest, 480)));
}

} // namespace esm
