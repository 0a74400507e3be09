#include "widgets/view/projector_handles.h"

#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {
namespace {

using Eigen::Vector3d;
using PhotoHandle = ProjectorHandle::Kind;

constexpr double shortSight = 0.35; // sine to the line of sight below which an axis has no handle
constexpr double flatPhoto = 0.2;   // cosine to the line of sight below which a photo is seen from its edge
constexpr double nearestTarget = 0.05; // of the way to it that an eye keeps
const double turnStep = toRadians(15);

Vector3d photoMiddle(const PhotoFace& photo) {
    const auto corners = photoCorners(photo.projector, photo.size, photo.depth);
    return (corners[0] + corners[2]) / 2;
}

double inTurnSteps(double angle) {
    return turnStep * std::round(angle / turnStep);
}

/// About the one of the projector's own x and y axes about which it goes farther, in steps.
Eigen::Quaterniond inOwnSteps(const Eigen::Quaterniond& turn, const Eigen::Matrix3d& axes) {
    const Eigen::AngleAxisd whole(turn);
    const Vector3d own = axes.transpose() * (whole.angle() * whole.axis());
    const Eigen::Index axis = std::abs(own.x()) > std::abs(own.y()) ? 0 : 1;
    return Eigen::Quaterniond(Eigen::AngleAxisd(inTurnSteps(own[axis]), axes.col(axis)));
}

/// How far along a line the point lies that is nearest to a ray, m; nothing where both run alike.
std::optional<double> lengthToRay(const Ray& line, const Ray& ray) {
    const Vector3d along = line.direction, direction = ray.direction.normalized();
    const Vector3d offset = ray.origin - line.origin;
    const double slant = along.dot(direction), sine = 1 - slant * slant;
    if (sine < 1e-3) return std::nullopt;
    return (along.dot(offset) - slant * direction.dot(offset)) / sine;
}

/// By a length in m.
Projector movedAlong(const PhotoFace& photo, const Vector3d& target, double length) {
    const Ray sight = photoSight(photo);
    Projector result = photo.projector;
    const double way = (target - result.pose.translation()).dot(sight.direction);
    const bool hasEye = result.kind == ProjectorKind::Perspective;
    result.pose.translation() +=
        (hasEye && way > 0 ? std::min(length, (1 - nearestTarget) * way) : length) * sight.direction;
    return result;
}

} // namespace

Ray photoSight(const PhotoFace& photo) {
    const Projector& projector = photo.projector;
    const Vector3d place = projector.pose.translation(), ahead = -projector.pose.linear().col(2);
    const bool isParallel = projector.kind == ProjectorKind::Parallel || !(photo.depth > 0);
    return {place, isParallel ? ahead : Vector3d((photoMiddle(photo) - place).normalized())};
}

std::vector<ProjectorHandle> projectorHandles(const PhotoFace& photo, const Camera& camera, double reach) {
    std::vector<ProjectorHandle> found;
    const auto places = handles(photo);
    found.reserve(places.size() + 3);
    for (std::size_t place = 0; place < places.size(); ++place)
        found.push_back({PhotoHandle::Size, place, places[place], places[place]});
    const Vector3d middle = photoMiddle(photo), ahead = photoSight(photo).direction;
    const Vector3d towards = towardsViewer(camera, middle), upwards = photo.projector.pose.linear().col(1);
    const Vector3d &below = places[4], &above = places[6];
    if (std::abs(photo.projector.pose.linear().col(2).dot(towards)) > flatPhoto)
        found.push_back({PhotoHandle::Roll, 0, above + reach * upwards, above});
    found.push_back({PhotoHandle::Turn, 0, below - reach * upwards, below});
    if (ahead.cross(towards).norm() > shortSight) {
        const bool hasEye = photo.projector.kind == ProjectorKind::Perspective;
        const double length = hasEye ? std::min(1.5 * reach, 0.5 * photo.depth) : 1.5 * reach;
        found.push_back({PhotoHandle::Push, 0, middle - length * ahead, middle});
    }
    return found;
}

Projector turnedAbout(const Projector& projector, const Vector3d& point, const Eigen::Quaterniond& turn) {
    Projector result = projector;
    result.pose.linear() = turn * projector.pose.linear();
    result.pose.translation() = point + turn * (projector.pose.translation() - point);
    return result;
}

/// A photo that lies close to its target would whirl around it: it is gripped at least half its diagonal
/// away.
Vector3d turnedPlace(const ProjectorTurn& what) {
    const PhotoFace& photo = what.photo;
    const Vector3d ahead = photoSight(photo).direction, place = photo.projector.pose.translation();
    const auto corners = photoCorners(photo.projector, photo.size, photo.depth);
    const double least = (corners[2] - corners[0]).norm() / 2;
    if (what.aboutItself) return place + std::max((what.target - place).dot(ahead), least) * ahead;
    return what.target - std::max((what.target - photoMiddle(photo)).dot(ahead), least) * ahead;
}

Projector turned(const ProjectorTurn& what, const Ray& grip, const Ray& ray) {
    const Projector& start = what.photo.projector;
    const Vector3d centre = what.aboutItself ? Vector3d(start.pose.translation()) : what.target;
    Eigen::Quaterniond turn = ballTurn(centre, {turnedPlace(what), grip}, ray);
    if (what.inSteps) turn = inOwnSteps(turn, start.pose.linear());
    return turnedAbout(start, centre, turn);
}

Projector rolled(const PhotoFace& photo, const Ray& from, const Ray& to, bool inSteps) {
    const Vector3d middle = photoMiddle(photo), ahead = photoSight(photo).direction;
    const DragPlane plane{middle, photo.projector.pose.linear().col(2)};
    const auto start = meet(from, plane), end = meet(to, plane);
    if (!start || !end) return photo.projector;
    const Vector3d a = *start - middle, b = *end - middle;
    const double angle = std::atan2(plane.normal.dot(a.cross(b)), a.dot(b));
    const Eigen::AngleAxisd roll(inSteps ? inTurnSteps(angle) : angle, -ahead);
    return turnedAbout(photo.projector, middle, Eigen::Quaterniond(roll));
}

Projector pushed(const PhotoFace& photo, const Vector3d& target, const Ray& from, const Ray& to) {
    const Ray sight = photoSight(photo);
    const auto start = lengthToRay(sight, from), end = lengthToRay(sight, to);
    return start && end ? movedAlong(photo, target, *end - *start) : photo.projector;
}

Projector pushedBy(const PhotoFace& photo, const Vector3d& target, double share) {
    const Ray sight = photoSight(photo);
    return movedAlong(photo, target, share * std::abs((target - sight.origin).dot(sight.direction)));
}

double turnBetween(const Projector& a, const Projector& b) {
    const Eigen::Matrix3d turn = a.pose.linear().transpose() * b.pose.linear();
    return toDegrees(Eigen::AngleAxisd(turn).angle());
}

} // namespace esm
