#include "core/texture/projection/likely_cameras.h"

#include <algorithm>
#include <array>
#include <opencv2/calib3d.hpp>

namespace esm {

namespace {

using Triple3 = std::array<std::size_t, 3>;

/// The triple of that number among all of `count` in lexicographic order (the combinatorial number system):
/// any of them at once, without making those before it.
Triple3 tripleAt(std::size_t number, std::size_t count) {
    Triple3 triple{};
    for (;; ++triple[0]) {
        const std::size_t left = count - triple[0] - 1, pairs = left * (left - 1) / 2;
        if (number < pairs) break;
        number -= pairs;
    }
    for (triple[1] = triple[0] + 1; number >= count - triple[1] - 1; ++triple[1])
        number -= count - triple[1] - 1;
    triple[2] = triple[1] + 1 + number;
    return triple;
}

/// All of them, or so many spread evenly over them, which takes no random numbers.
std::vector<Triple3> triplesOf(std::size_t count, std::size_t mostTriples) {
    const std::size_t all = count * (count - 1) * (count - 2) / 6, chosen = std::min(all, mostTriples);
    std::vector<Triple3> triples(chosen);
    for (std::size_t i = 0; i < chosen; ++i)
        triples[i] = tripleAt(i * all / chosen, count);
    return triples;
}

cv::Matx33d matrixOf(const Intrinsics& camera) {
    return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

/// Three points that are seen leave up to four poses (P3P, Grunert 1841); each of them is a candidate, and
/// the other pairs decide. Three and not four or more, as the fewer pairs a candidate takes, the more likely
/// all of them are right: RANSAC (Fischler and Bolles 1981), but with all triples in place of random ones.
void addCamerasOf(const Triple3& triple, const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                  std::vector<PinholeCamera>& cameras) {
    std::vector<cv::Point3d> organ;
    std::vector<cv::Point2d> photo;
    for (const std::size_t i : triple) {
        organ.emplace_back(pairs[i].organ.x(), pairs[i].organ.y(), pairs[i].organ.z());
        photo.emplace_back(pairs[i].photo.x(), pairs[i].photo.y());
    }
    std::vector<cv::Mat> turns, shifts;
    try {
        cv::solveP3P(organ, photo, matrixOf(intrinsics), cv::noArray(), turns, shifts, cv::SOLVEPNP_P3P);
    } catch (const cv::Exception&) {
        return; // three points that tell nothing
    }
    for (std::size_t i = 0; i < turns.size(); ++i) {
        const Eigen::Vector3d turn(turns[i].at<double>(0), turns[i].at<double>(1), turns[i].at<double>(2));
        PinholeCamera camera;
        camera.intrinsics = intrinsics;
        camera.translation = {shifts[i].at<double>(0), shifts[i].at<double>(1), shifts[i].at<double>(2)};
        if (turn.norm() > 0) camera.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized());
        if (camera.rotation.allFinite() && camera.translation.allFinite()) cameras.push_back(camera);
    }
}

} // namespace

std::vector<PinholeCamera> likelyCameras(const std::vector<LandmarkPair>& pairs, const Intrinsics& intrinsics,
                                         double tolerance, const SearchEffort& effort) {
    std::vector<PinholeCamera> cameras;
    for (const Triple3& triple : triplesOf(pairs.size(), effort.triples))
        addCamerasOf(triple, pairs, intrinsics, cameras);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < cameras.size(); ++i)
        order.emplace_back(cappedSquares(pairErrors(cameras[i], pairs), tolerance), i);
    std::sort(order.begin(), order.end());
    std::vector<PinholeCamera> best;
    for (std::size_t i = 0; i < std::min(effort.cameras, order.size()); ++i)
        best.push_back(cameras[order[i].second]);
    return best;
}

} // namespace esm
