#include "core/surface/surface_query.h"

#include "core/geometry/nearest_weights.h"
#include "core/support/errors.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace esm {

namespace {

/// @throws InvalidModel when Embree could not do what it was asked for last
void checkLastError(RTCDevice device) {
    const RTCError error = rtcGetDeviceError(device);
    if (error == RTC_ERROR_NONE) return;
    if (error == RTC_ERROR_OUT_OF_MEMORY)
        throw InvalidModel("the surface is too large for the memory there is");
    throw InvalidModel("rays cannot be followed to the surface on this machine (Embree error " +
                       std::to_string(static_cast<int>(error)) + ")");
}

RTCDevice newDevice() {
    RTCDevice device = rtcNewDevice(nullptr);
    if (!device) checkLastError(nullptr);
    return device;
}

} // namespace

struct SurfaceQuery::Implementation {
    struct DeviceDeleter {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    };
    struct SceneDeleter {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };
    struct GeometryDeleter {
        void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
    };
    using Device = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
    using Scene = std::unique_ptr<RTCSceneTy, SceneDeleter>;
    using Geometry = std::unique_ptr<RTCGeometryTy, GeometryDeleter>;

    Implementation(const std::vector<Eigen::Vector3d>& initialPositions,
                   std::vector<Triangle> initialTriangles);

    struct Nearest;

    void setPositions(const std::vector<Eigen::Vector3d>& newPositions);
    void commitScene();
    Eigen::Vector3f scaled(const Eigen::Vector3d& point) const {
        return ((point - centre) * scale).cast<float>();
    }
    RTCRay scaledRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
    const Eigen::Vector3d& corner(std::uint32_t triangle, std::size_t index) const {
        return positions[triangles[triangle][index]];
    }

    std::vector<Eigen::Vector3d> positions;
    std::vector<Triangle> triangles;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< of the positions' box
    double scale = 1;                                 ///< brings the box to the size 2
    Device device;
    Scene scene;
    Geometry geometry;
    float* scaledPositions = nullptr; ///< owned by the geometry
};

// A tree of boxes over the triangles (Embree, Wald et al. 2014): a ray or a point passes over whole branches
// whose box it does not meet, in time that grows with the logarithm of the triangles. Where vertices move the
// tree keeps its branches and only its boxes are made anew (refitted), in one pass. It becomes worse the
// farther the surface goes from the shape it was built for, but tissue keeps its neighbours.
//
// Robust, so that a ray through an edge does not slip between the two triangles there: organs would have
// pinholes.
SurfaceQuery::Implementation::Implementation(const std::vector<Eigen::Vector3d>& initialPositions,
                                             std::vector<Triangle> initialTriangles)
    : triangles(std::move(initialTriangles)), device(newDevice()), scene(rtcNewScene(device.get())),
      geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE)) {
    for (const Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle)
            if (vertex >= initialPositions.size())
                throw InvalidModel("a triangle of the surface names no vertex");
    rtcSetSceneFlags(scene.get(), static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST));
    scaledPositions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), std::max<std::size_t>(initialPositions.size(), 1)));
    void* indices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(Triangle), std::max<std::size_t>(triangles.size(), 1));
    checkLastError(device.get());
    std::copy(triangles.begin(), triangles.end(), static_cast<Triangle*>(indices));
    rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_REFIT);
    setPositions(initialPositions);
    if (!triangles.empty()) rtcAttachGeometry(scene.get(), geometry.get());
    commitScene();
}

void SurfaceQuery::Implementation::commitScene() {
    rtcCommitScene(scene.get());
    checkLastError(device.get());
}

// The tree works in single precision. Brought to the middle and to the size 2, a surface loses 10⁻⁷ of its
// own size to that, wherever it lies and whatever its unit is. Where the tree has found a triangle, the
// answer is computed anew in double from the triangle's true corners.
void SurfaceQuery::Implementation::setPositions(const std::vector<Eigen::Vector3d>& newPositions) {
    for (const Eigen::Vector3d& position : newPositions)
        if (!position.allFinite()) throw InvalidModel("a vertex of the surface is at no finite place");
    positions = newPositions;
    const Eigen::AlignedBox3d box = boundingBox(positions);
    const double extent = box.isEmpty() ? 0 : box.sizes().maxCoeff();
    centre = box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center());
    scale = extent > 0 ? 2 / extent : 1;
    for (std::size_t i = 0; i < positions.size(); ++i)
        Eigen::Map<Eigen::Vector3f>(scaledPositions + 3 * i) = scaled(positions[i]);
    rtcUpdateGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry.get());
    checkLastError(device.get());
}

RTCRay SurfaceQuery::Implementation::scaledRay(const Eigen::Vector3d& origin,
                                               const Eigen::Vector3d& direction) const {
    const Eigen::Vector3f from = scaled(origin), along = direction.cast<float>();
    RTCRay ray{};
    ray.org_x = from.x();
    ray.org_y = from.y();
    ray.org_z = from.z();
    ray.dir_x = along.x();
    ray.dir_y = along.y();
    ray.dir_z = along.z();
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.mask = ~0U;
    return ray;
}

SurfaceQuery::SurfaceQuery(const std::vector<Eigen::Vector3d>& positions,
                           const std::vector<Triangle>& triangles)
    : m_implementation(std::make_unique<Implementation>(positions, triangles)) {}
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;
SurfaceQuery::~SurfaceQuery() = default;

void SurfaceQuery::refit(const std::vector<Eigen::Vector3d>& positions) {
    if (positions.size() != m_implementation->positions.size())
        throw InvalidModel("the surface has " + std::to_string(m_implementation->positions.size()) +
                           " vertices and was given " + std::to_string(positions.size()) + " positions");
    m_implementation->setPositions(positions);
    m_implementation->commitScene();
}

// The tree says which triangle, the triangle's plane in double how far and where. A hit on the last digits of
// an edge may lie a little outside the triangle that way; the nearest of its points is taken, so that weights
// never leave 0 to 1.
std::optional<RayHit> SurfaceQuery::firstHit(const Ray& ray) const {
    const Implementation& surface = *m_implementation;
    const double length = ray.direction.norm();
    if (!(length > 0) || !std::isfinite(length) || !ray.origin.allFinite()) return std::nullopt;
    const Eigen::Vector3d direction = ray.direction / length;
    // A far origin is brought near first, lest float loses the surface.
    const double toCentre = (surface.centre - ray.origin).dot(direction);
    const double skipped = std::max(0.0, toCentre - 2 / surface.scale);

    RTCRayHit query{};
    query.ray = surface.scaledRay(ray.origin + skipped * direction, direction);
    query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(surface.scene.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

    const std::uint32_t triangle = query.hit.primID;
    const Eigen::Vector3d &a = surface.corner(triangle, 0), &b = surface.corner(triangle, 1),
                          &c = surface.corner(triangle, 2);
    const Eigen::Vector3d normal = (b - a).cross(c - a), fromA = ray.origin - a;
    const double across = direction.dot(normal), squared = normal.squaredNorm();
    const double hitInFloat = skipped + double{query.ray.tfar} / surface.scale;
    // A triangle seen edge-on, to a millionth, has no better distance than the one found.
    const bool edgeOn = !(across * across > 1e-12 * squared);
    const double distance = edgeOn ? hitInFloat : std::max(0.0, -fromA.dot(normal) / across);
    const Eigen::Vector3d place = ray.origin + distance * direction;
    return RayHit{triangle, nearestWeights(place, a, b, c), distance};
}

struct SurfaceQuery::Implementation::Nearest {
    const Implementation& surface;
    Eigen::Vector3d point;
    std::optional<RayHit> best;

    /// Keeps what lies as near as the best in reach, so that the tree's order does not choose among equals. A
    /// point over an edge is as near to both triangles; the tree, whose boxes are in single precision, must
    /// pass over neither. The reach is therefore a little more than the best distance: by 10⁻⁵ of it and of
    /// half the surface's size, a hundred times what rounding takes. It never grows again.
    static bool visit(RTCPointQueryFunctionArguments* arguments) {
        constexpr double slack = 1 + 1e-5;
        auto& self = *static_cast<Nearest*>(arguments->userPtr);
        const std::uint32_t triangle = arguments->primID;
        const Eigen::Vector3d &a = self.surface.corner(triangle, 0), &b = self.surface.corner(triangle, 1),
                              &c = self.surface.corner(triangle, 2);
        const Eigen::Vector3d weights = nearestWeights(self.point, a, b, c);
        const double distance = (weights.x() * a + weights.y() * b + weights.z() * c - self.point).norm();
        if (self.best &&
            std::make_pair(distance, triangle) >= std::make_pair(self.best->distance, self.best->triangle))
            return false;
        self.best = RayHit{triangle, weights, distance};
        const double reach = slack * distance * self.surface.scale + 1e-5;
        arguments->query->radius = std::min(arguments->query->radius, static_cast<float>(reach));
        return true;
    }
};

std::optional<RayHit> SurfaceQuery::nearest(const Eigen::Vector3d& point) const {
    const Implementation& surface = *m_implementation;
    if (!point.allFinite() || surface.triangles.empty()) return std::nullopt;
    const Eigen::Vector3f place = surface.scaled(point);
    RTCPointQuery query{};
    query.x = place.x();
    query.y = place.y();
    query.z = place.z();
    query.radius = std::numeric_limits<float>::infinity();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    Implementation::Nearest nearest{surface, point, std::nullopt};
    rtcPointQuery(surface.scene.get(), &query, &context, &Implementation::Nearest::visit, &nearest);
    return nearest.best;
}

// Any triangle in between will do, so that the tree may stop at the first it meets, which need not be the
// nearest. The margin keeps a point on the surface from being hidden by the triangle that it lies on.
bool SurfaceQuery::isBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin) const {
    const Implementation& surface = *m_implementation;
    const Eigen::Vector3d between = to - from;
    const double length = between.norm();
    if (!(length > 2 * margin) || !std::isfinite(length)) return false;
    RTCRay ray = surface.scaledRay(from + margin / length * between, between / length);
    ray.tfar = static_cast<float>((length - 2 * margin) * surface.scale);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(surface.scene.get(), &context, &ray);
    return ray.tfar < 0;
}

} // namespace esm
