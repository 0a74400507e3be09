#include "core/texture/photo/mask_outlines.h"

#include <opencv2/imgproc.hpp>

namespace esm {

namespace {

using Contour = std::vector<cv::Point>;

/// Contours go through the middles of a mask's outermost pixels; half a pixel of brush brings them to its
/// border. Of a hole they go through the mask around it.
PhotoStroke strokeAlong(const Contour& contour, double detail, bool isHole) {
    Contour simpler;
    cv::approxPolyDP(contour, simpler, detail, true);
    PhotoStroke stroke;
    stroke.radius = 0.5;
    stroke.isFilled = true;
    stroke.takesBack = isHole;
    stroke.path.reserve(simpler.size());
    for (const cv::Point& place : simpler)
        stroke.path.emplace_back(place.x + 0.5, place.y + 0.5);
    return stroke;
}

} // namespace

std::vector<PhotoStroke> strokesAround(const cv::Mat& mask, double detail, bool withHoles) {
    std::vector<Contour> contours;
    std::vector<cv::Vec4i> family; // next, before, first child, parent
    cv::findContours(mask, contours, family, withHoles ? cv::RETR_CCOMP : cv::RETR_EXTERNAL,
                     cv::CHAIN_APPROX_NONE);
    std::vector<PhotoStroke> strokes;
    strokes.reserve(contours.size());
    for (const bool isHole : {false, true})
        for (std::size_t i = 0; i < contours.size(); ++i)
            if ((family[i][3] >= 0) == isHole && (!isHole || cv::contourArea(contours[i]) > 4))
                strokes.push_back(strokeAlong(contours[i], detail, isHole));
    return strokes;
}

} // namespace esm
