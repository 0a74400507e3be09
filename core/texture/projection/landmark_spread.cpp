#include "core/texture/projection/landmark_spread.h"

#include <Eigen/SVD>

namespace esm {

namespace {

/// Of the extent of points: narrower across, they are a line.
constexpr double lineShare = 1e-3;

/// The same, from where on they are nearly one, or a plane by their thickness.
constexpr double weakLineShare = 0.12, weakPlaneShare = 0.08;

/// Of the photo's diagonal: the standard deviation about their middle of landmarks that are close together.
/// Spread evenly all over it they have 0.29.
constexpr double weakExtent = 0.06;

/// How far points reach along their main directions: singular values of what is left of them about their
/// middle, the largest first.
template<int dimensions>
Eigen::Matrix<double, dimensions, 1>
extents(const Eigen::Matrix<double, dimensions, Eigen::Dynamic>& points) {
    const Eigen::MatrixXd off = points.colwise() - points.rowwise().mean();
    Eigen::Matrix<double, dimensions, 1> all = Eigen::Matrix<double, dimensions, 1>::Zero();
    const Eigen::VectorXd found = Eigen::JacobiSVD<Eigen::MatrixXd>(off).singularValues();
    all.head(found.size()) = found;
    return all;
}

Eigen::Matrix2Xd inPhoto(const std::vector<LandmarkPair>& pairs) {
    Eigen::Matrix2Xd points(2, pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = pairs[i].photo;
    return points;
}

Eigen::Matrix3Xd onOrgan(const std::vector<LandmarkPair>& pairs) {
    Eigen::Matrix3Xd points(3, pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = pairs[i].organ;
    return points;
}

} // namespace

std::vector<Weakness> weaknessesOf(const std::vector<LandmarkPair>& pairs, const std::vector<bool>& counts,
                                   double photoDiagonal) {
    std::vector<LandmarkPair> counting;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (counts[i]) counting.push_back(pairs[i]);
    const Eigen::Vector2d photo = extents<2>(inPhoto(counting));
    const Eigen::Vector3d organ = extents<3>(onOrgan(counting));
    std::vector<Weakness> weaknesses;
    if (photo[1] < weakLineShare * photo[0] || organ[1] < weakLineShare * organ[0])
        weaknesses.push_back(Weakness::NearlyOnALine);
    else if (organ[2] < weakPlaneShare * organ[0])
        weaknesses.push_back(Weakness::NearlyPlanar);
    if (photo.norm() < weakExtent * photoDiagonal * std::sqrt(static_cast<double>(counting.size())))
        weaknesses.push_back(Weakness::CloseTogether);
    return weaknesses;
}

bool isOnALineInPhoto(const std::vector<LandmarkPair>& pairs) {
    const Eigen::Vector2d found = extents<2>(inPhoto(pairs));
    return found[1] <= lineShare * found[0];
}

bool isOnALineOnOrgan(const std::vector<LandmarkPair>& pairs) {
    const Eigen::Vector3d found = extents<3>(onOrgan(pairs));
    return found[1] <= lineShare * found[0];
}

} // namespace esm
