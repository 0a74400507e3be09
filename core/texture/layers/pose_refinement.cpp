#include "core/texture/layers/pose_refinement.h"

#include "core/surface/surface_query.h"
#include "core/texture/layers/photo_ray.h"
#include "core/texture/layers/surface_beneath.h"
#include "core/texture/photo/evened_brightness.h"
#include "core/texture/photo/photo_sampler.h"
#include "core/texture/projection/damped_descent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Of the photo's longer side, pixels: coarse ones first, in which a photo that lies far off still overlaps
/// what it shows, then finer ones.
constexpr std::array<int, 4> sizes{100, 200, 400, 800};

constexpr std::size_t fewestSamples = 300;
constexpr double leastShareSeen = 0.6;  ///< of the samples that a pose must leave in the photo
constexpr double usualDifference = 0.5; ///< of evened brightness: from there on a difference counts less
constexpr double mostDifference = 0.9;  ///< of a photo that shows the same: a correlation of 0.6
constexpr DescentLimits alignmentLimits{40, 1e-5, 1e6};
constexpr std::uint8_t baseShare = 26; ///< of 255: where the base colour takes more, nothing lies beneath

/// A point of the surface, and how the layers beneath show it.
struct Sample {
    Eigen::Vector3d point; ///< m
    double value;          ///< evened brightness
};

/// Those of the layers beneath that hide the base colour: whether it is black or white makes no difference.
Image coveredSurface(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                     const PhotoPlane& plane, const Progress& progress) {
    ProgressParts parts(progress);
    Image black = surfaceBeneath(mesh, beneath, {0, 0, 0}, plane, parts.next(0.5));
    const Image white = surfaceBeneath(mesh, beneath, {255, 255, 255}, plane, parts.rest());
    for (int y = 0; y < black.height; ++y)
        for (int x = 0; x < black.width; ++x)
            if (white.at(x, y)[1] - black.at(x, y)[1] > baseShare) black.at(x, y)[3] = 0;
    return black;
}

std::vector<Sample> samplesOf(const TriangleMesh& mesh, const EvenedBrightness& surface,
                              const PhotoPlane& plane) {
    const SurfaceQuery query(mesh.vertices, mesh.triangles);
    const double perColumn = static_cast<double>(plane.photo.width) / surface.width;
    const double perRow = static_cast<double>(plane.photo.height) / surface.height;
    std::vector<Sample> samples;
    for (int y = 0; y < surface.height; ++y)
        for (int x = 0; x < surface.width; ++x) {
            const std::size_t pixel = surface.index(x, y);
            if (surface.counts[pixel] == 0) continue;
            const auto hit = query.firstHit(
                rayThrough(plane.projector, plane.photo, {(x + 0.5) * perColumn, (y + 0.5) * perRow}));
            if (!hit) continue;
            const Triangle& corners = mesh.triangles[hit->triangle];
            Eigen::Vector3d point = Eigen::Vector3d::Zero();
            for (std::size_t i = 0; i < 3; ++i)
                point += hit->barycentric[static_cast<Eigen::Index>(i)] * mesh.vertices[corners[i]];
            samples.push_back({point, surface.values[pixel]});
        }
    return samples;
}

using PoseStep = Eigen::Matrix<double, 6, 1>; ///< a turn and a shift in units of the samples' size

/// Poses near one, as seen from the middle of the samples: turns about it leave it in its place, so that
/// turns and shifts hardly stand in for each other.
struct PoseSpace {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double size = 0; ///< m

    explicit PoseSpace(const std::vector<Sample>& samples) {
        for (const Sample& sample : samples)
            middle += sample.point / static_cast<double>(samples.size());
        for (const Sample& sample : samples)
            size = std::max(size, (sample.point - middle).norm());
    }

    Projector moved(Projector projector, const PoseStep& step) const {
        const Eigen::Vector3d turn = step.head<3>();
        Eigen::Isometry3d about = Eigen::Isometry3d::Identity();
        about.translate(Eigen::Vector3d(middle + size * step.tail<3>()));
        if (turn.norm() > 0) about.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
        about.translate(-middle);
        projector.pose = about * projector.pose;
        return projector;
    }
};

/// Where samples are seen in a picture of the photo.
class SeenFrom {
public:
    SeenFrom(const Projector& projector, PhotoSize photo, const EvenedBrightness& picture)
        : m_matrix(photoMatrix(projector, photo)),
          m_scale(static_cast<double>(picture.width) / photo.width,
                  static_cast<double>(picture.height) / photo.height) {}

    /// Not finite behind the eye.
    Eigen::Vector2d placeOf(const Eigen::Vector3d& point) const {
        const Eigen::Vector4d seen = m_matrix * point.homogeneous();
        if (!(seen.z() > 0)) return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
        return (seen.head<2>() / seen.z()).cwiseProduct(m_scale);
    }

private:
    Eigen::Matrix4d m_matrix;
    Eigen::Vector2d m_scale;
};

struct AlignmentEquations {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    PoseStep gradient = PoseStep::Zero();
    double cost = std::numeric_limits<double>::infinity(); ///< on the mean of the samples that are seen
};

/// One size of the photo, and what lies beneath it.
class Alignment {
public:
    Alignment(const EvenedBrightness& picture, PhotoSize photo, const std::vector<Sample>& samples)
        : m_picture(picture), m_photo(photo), m_samples(samples), m_space(samples) {}

    /// Differences that are large against what is usual (a highlight, an instrument) count by their size and
    /// no longer by its square (Huber 1964).
    Projector aligned(const Projector& projector) const {
        return descended(
            projector, [&](const Projector& at) { return equationsAt(at); },
            [&](const Projector& at, const PoseStep& step) { return m_space.moved(at, step); },
            alignmentLimits);
    }

    /// See `PoseRefinement::errorBefore`.
    double error(const Projector& projector) const {
        const SeenFrom seen(projector, m_photo, m_picture);
        double squares = 0, count = 0;
        for (const Sample& sample : m_samples)
            if (const auto found = brightnessAt(m_picture, seen.placeOf(sample.point))) {
                squares += std::pow(found->value - sample.value, 2);
                ++count;
            }
        return std::sqrt(squares / std::max(1.0, count));
    }

    double moved(const Projector& before, const Projector& after) const {
        const SeenFrom first(before, m_photo, m_picture), second(after, m_photo, m_picture);
        double squares = 0;
        for (const Sample& sample : m_samples)
            squares += (second.placeOf(sample.point) - first.placeOf(sample.point)).squaredNorm();
        return std::sqrt(squares / static_cast<double>(m_samples.size())) * m_photo.width / m_picture.width;
    }

private:
    /// How a sample's place moves with the pose is asked of six poses nearby: it serves both kinds of
    /// projectors, and costs little beside reading the picture.
    AlignmentEquations equationsAt(const Projector& projector) const {
        constexpr double nearby = 1e-6;
        const SeenFrom seen(projector, m_photo, m_picture);
        std::vector<SeenFrom> movedSlightly;
        movedSlightly.reserve(6);
        for (Eigen::Index i = 0; i < 6; ++i)
            movedSlightly.emplace_back(m_space.moved(projector, nearby * PoseStep::Unit(i)), m_photo,
                                       m_picture);
        AlignmentEquations equations;
        double cost = 0, count = 0;
        for (const Sample& sample : m_samples) {
            const Eigen::Vector2d place = seen.placeOf(sample.point);
            const auto found = brightnessAt(m_picture, place);
            if (!found) continue;
            const double off = found->value - sample.value, size = std::abs(off);
            const double weight = size <= usualDifference ? 1 : usualDifference / size;
            PoseStep derivative;
            for (std::size_t i = 0; i < 6; ++i)
                derivative[static_cast<Eigen::Index>(i)] =
                    found->gradient.dot(movedSlightly[i].placeOf(sample.point) - place) / nearby;
            equations.normal += weight * derivative * derivative.transpose();
            equations.gradient += weight * off * derivative;
            cost += size <= usualDifference ? off * off / 2 : usualDifference * (size - usualDifference / 2);
            ++count;
        }
        if (count >= leastShareSeen * static_cast<double>(m_samples.size())) equations.cost = cost / count;
        return equations;
    }

    const EvenedBrightness& m_picture;
    PhotoSize m_photo;
    const std::vector<Sample>& m_samples;
    PoseSpace m_space;
};

Image reduced(Image photo, int longerSide) {
    while (std::max(photo.width, photo.height) > longerSide)
        photo = halved(photo);
    return photo;
}

} // namespace

/// Direct alignment, as in visual odometry (Engel et al. 2018): each pixel of what lies beneath is a point of
/// the surface whose brightness is known, and the pose is sought from which the photo shows all of them so.
/// No landmarks are sought in the pictures, which wet tissue has few of.
std::optional<PoseRefinement> refinedPose(const TriangleMesh& mesh, const std::vector<TextureLayer>& beneath,
                                          const TextureLayer& layer, const Progress& progress) {
    const Image& picture = *pictureOf(layer);
    const PhotoSize photo = sizeOf(picture);
    ProgressParts parts(progress);
    PoseRefinement refinement{layer.projector, 0, 0, 0};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const Image small = reduced(picture, sizes[i]);
        const PhotoPlane plane{refinement.projector, photo, sizeOf(small)};
        const Image surface = coveredSurface(mesh, beneath, plane, parts.next(0.25));
        const std::vector<Sample> samples = samplesOf(mesh, evenedBrightness(surface, surface), plane);
        if (samples.size() < fewestSamples) return std::nullopt;
        const EvenedBrightness evened =
            evenedBrightness(small, surface); // without what lies behind the organ
        const Alignment alignment(evened, photo, samples);
        refinement.projector = alignment.aligned(refinement.projector);
        refinement.errorBefore = alignment.error(layer.projector);
        refinement.errorAfter = alignment.error(refinement.projector);
        refinement.moved = alignment.moved(layer.projector, refinement.projector);
    }
    reportProgress(progress, 1);
    if (!(refinement.errorAfter < std::min(refinement.errorBefore, mostDifference))) return std::nullopt;
    return refinement;
}

} // namespace esm
