#include "core/texture/photo/photo_preparation.h"
#include "tests/support/colour_difference.h"
#include "tests/support/made_photo.h"
#include "tests/support/rounds.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace esm;

namespace {

/// How often something was said, how often rightly, and how much of what there is was found.
struct Hits {
    double found = 0, right = 0, there = 0, met = 0;

    void count(bool isFound, bool isThere, bool mayBeFound) {
        found += isFound ? 1 : 0;
        right += isFound && mayBeFound ? 1 : 0;
        there += isThere ? 1 : 0;
        met += isFound && isThere ? 1 : 0;
    }
    void add(const Hits& other) {
        found += other.found;
        right += other.right;
        there += other.there;
        met += other.met;
    }
    double recall() const { return there > 0 ? met / there : 1; }
    double precision() const { return found > 0 ? right / found : 1; }
};

struct Mean {
    double sum = 0, count = 0;
    void add(double value) {
        sum += value;
        ++count;
    }
    double value() const { return count > 0 ? sum / count : 0; }
};

/// What was found in one photo, compared with what is true of it.
struct Findings {
    std::string name;
    bool saysField = false, hasField = false;
    double overlap = 0; ///< of the field found and the true one, intersection over union
    Hits overlays, flecks;
    double pale = 0, paleTaken = 0;  ///< pixels of pale objects where no fleck is; those taken for one
    double filled = 0, balanced = 0; ///< ΔE₀₀, mean over what is filled, and over what does not shine
    bool isBalanced = false;

    double paleShare() const { return pale > 0 ? paleTaken / pale : 0; }
};

bool isSet(const cv::Mat& mask, int x, int y) {
    return mask.at<std::uint8_t>(y, x) != 0;
}

/// Where text and boxes hide the field nothing is known of it.
double overlapOf(const std::optional<PhotoField>& field, const MadePhoto& photo) {
    Image masked = photo.image;
    PhotoField whole = field.value_or(PhotoField());
    whole.trim = 0;
    if (field) maskField(masked, whole);
    double both = 0, either = 0;
    for (int y = 0; y < masked.height; ++y)
        for (int x = 0; x < masked.width; ++x) {
            const bool found = masked.at(x, y)[3] > 127, is = isSet(photo.field, x, y);
            if (isSet(photo.overlays, x, y)) continue;
            both += found && is ? 1 : 0;
            either += found || is ? 1 : 0;
        }
    return both / either;
}

Hits overlaysFound(const Image& inField, const Image& shown, const MadePhoto& photo) {
    Hits hits;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x)
            if (inField.at(x, y)[3] > 127) {
                const bool is = isSet(photo.overlays, x, y);
                hits.count(shown.at(x, y)[3] < 128, is, is);
            }
    return hits;
}

/// A fleck is there where it makes a pixel brighter by a tenth of full light; what lies within two pixels of
/// where it does by a fiftieth is rightly filled.
void compareFlecks(const Image& shown, const MadePhoto& photo, Findings& findings) {
    const PixelMask mask = highlightMask(shown, usualSensitivity);
    Image filled = shown;
    fillHighlights(filled, mask);
    cv::Mat around;
    cv::dilate(photo.shine > 0.02, around, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    Mean difference;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x) {
            if (shown.at(x, y)[3] < 128) continue;
            const auto place = static_cast<std::size_t>(y * shown.width + x);
            findings.flecks.count(mask[place] != 0, photo.shine.at<float>(y, x) > 0.1F, isSet(around, x, y));
            if (isSet(photo.pale, x, y) && !isSet(around, x, y)) {
                ++findings.pale;
                findings.paleTaken += mask[place] != 0 ? 1 : 0;
            }
            if (mask[place] != 0)
                difference.add(colourDifference(labOf(filled.at(x, y)), labOf(photo.withoutFlecks.at(x, y))));
        }
    findings.filled = difference.value();
}

/// Every third pixel each way: the mean is the same.
void compareBalance(Image shown, const MadePhoto& photo, Findings& findings) {
    const auto gains = findWhiteBalance(shown);
    findings.isBalanced = gains.has_value();
    if (gains) multiplyColours(shown, *gains);
    Mean difference;
    for (int y = 0; y < shown.height; y += 3)
        for (int x = 0; x < shown.width; x += 3)
            if (shown.at(x, y)[3] == 255 && photo.shine.at<float>(y, x) < 0.02F)
                difference.add(colourDifference(labOf(shown.at(x, y)), labOf(photo.balanced.at(x, y))));
    findings.balanced = difference.value();
}

Findings findingsOf(const MadePhoto& photo) {
    Findings findings;
    findings.name = photo.name;
    findings.hasField = !photo.fillsFrame;
    PhotoPreparation preparation = withFound({}, photo.image, {true, false, false});
    findings.saysField = preparation.field.has_value();
    findings.overlap = overlapOf(preparation.field, photo);
    const Image inField = shownOf(photo.image, preparation);
    preparation = withFound(preparation, photo.image, {false, false, true});
    const Image shown = shownOf(photo.image, preparation);
    findings.overlays = overlaysFound(inField, shown, photo);
    compareFlecks(shown, photo, findings);
    compareBalance(shown, photo, findings);
    return findings;
}

std::vector<Findings> allFindings(std::uint64_t seed) {
    const int step = isSanitized() ? 7 : 1;
    std::vector<Findings> all(static_cast<std::size_t>((madePhotoCount + step - 1) / step));
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
        all[i] = findingsOf(madePhoto(static_cast<int>(i) * step, seed));
    });
    return all;
}

double worstOf(const std::vector<Findings>& all, double Findings::*value) {
    double worst = 0;
    for (const Findings& findings : all)
        worst = std::max(worst, findings.*value);
    return worst;
}

double meanOf(const std::vector<Findings>& all, double Findings::*value) {
    Mean mean;
    for (const Findings& findings : all)
        mean.add(findings.*value);
    return mean.value();
}

} // namespace

/// One test, as to make the photos takes most of the time. The figures stand in docs/performance.md.
TEST(MadePhotos, ArePreparedAsWellAsAimed) {
    const std::vector<Findings> all = allFindings(1);
    Hits overlays, flecks;
    Findings pale;
    double worstPale = 0;
    for (const Findings& findings : all) {
        EXPECT_LE(findings.paleShare(), 0.15) << findings.name;
        worstPale = std::max(worstPale, findings.paleShare());
        pale.pale += findings.pale;
        pale.paleTaken += findings.paleTaken;
        EXPECT_EQ(findings.saysField, findings.hasField) << findings.name;
        EXPECT_GE(findings.overlap, 0.98) << findings.name;
        overlays.add(findings.overlays);
        flecks.add(findings.flecks);
    }
    if (isSanitized()) return; // the aims below are of the whole set, and some of it was tried
    EXPECT_GE(overlays.recall(), 0.95);
    EXPECT_GE(flecks.recall(), 0.9);
    EXPECT_GE(flecks.precision(), 0.8);
    EXPECT_GT(pale.pale, 0);
    EXPECT_LE(pale.paleShare(), 0.05);
    const double filled = meanOf(all, &Findings::filled), balanced = meanOf(all, &Findings::balanced);
    EXPECT_LE(filled, 4);
    EXPECT_LE(worstOf(all, &Findings::filled), 10);
    EXPECT_LE(balanced, 3);
    EXPECT_LE(worstOf(all, &Findings::balanced), 10);
    const auto worstField = std::min_element(
        all.begin(), all.end(), [](const Findings& a, const Findings& b) { return a.overlap < b.overlap; });
    std::printf(
        "field %.4f, worst %.4f; overlays: recall %.3f, precision %.3f; flecks: recall %.3f, precision %.3f; "
        "pale taken %.4f, worst %.3f; filled %.2f, worst %.2f; white %.2f, worst %.2f\n",
        meanOf(all, &Findings::overlap), worstField->overlap, overlays.recall(), overlays.precision(),
        flecks.recall(), flecks.precision(), pale.paleShare(), worstPale, filled,
        worstOf(all, &Findings::filled), balanced, worstOf(all, &Findings::balanced));
}

TEST(MadePhotos, AreTheSameForTheSameSeed) {
    EXPECT_EQ(madePhoto(4, 3).image.pixels, madePhoto(4, 3).image.pixels);
    EXPECT_NE(madePhoto(4, 3).image.pixels, madePhoto(4, 4).image.pixels);
}

TEST(ColourDifference, IsAsPublished) {
    // Sharma, Wu, Dalal 2005, The CIEDE2000 color-difference formula, table 1: pairs 1, 10, 14, 25.
    EXPECT_NEAR(colourDifference({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(colourDifference({50, 2.49, -0.001}, {50, -2.49, 0.0011}), 7.2195, 1e-4);
    EXPECT_NEAR(colourDifference({50, -0.001, 2.49}, {50, 0.0011, -2.49}), 4.7461, 1e-4);
    EXPECT_NEAR(colourDifference({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
}
