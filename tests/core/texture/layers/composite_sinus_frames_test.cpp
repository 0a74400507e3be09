#include "tests/core/texture/layers/painted_pages.h"
#include "tests/support/shared_data.h"

#include <opencv2/imgproc.hpp>

#include <fstream>
#include <map>

/// Two frames of an endoscope in a nose, of known cameras, and the points that were reconstructed from the
/// whole sequence: a photo projected from the first frame's camera must show what the second frame shows.
namespace esm::test {
namespace {

std::filesystem::path sinusFile(const char* name) {
    return sharedData("images/sinus-sfm") / name;
}

std::vector<double> numbersIn(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istream_iterator<double>(stream), {}};
}

std::vector<Eigen::Vector3d> reconstructedPoints() {
    std::ifstream stream(sinusFile("structure.ply"));
    std::string line;
    while (std::getline(stream, line) && line != "end_header") {
    }
    std::vector<Eigen::Vector3d> points(570);
    for (Eigen::Vector3d& point : points)
        stream >> point.x() >> point.y() >> point.z();
    EXPECT_TRUE(stream.good());
    return points;
}

/// Camera to world, looking along +z with y down.
struct FramePose {
    Eigen::Quaterniond turn;
    Eigen::Vector3d eye;
};

FramePose framePose(int frame) {
    std::ifstream stream(sinusFile("motion.yaml"));
    std::vector<double> numbers; // position x y z, orientation x y z w, of one pose after the other
    for (std::string line; std::getline(stream, line);) {
        const std::size_t colon = line.find(": "), key = line.find_first_not_of(' ');
        if (colon == key + 1 && std::string("xyzw").find(line[key]) != std::string::npos)
            numbers.push_back(std::stod(line.substr(colon + 2)));
    }
    const double* n = &numbers.at(std::size_t(7 * frame));
    return {Eigen::Quaterniond(n[6], n[3], n[4], n[5]).normalized(), {n[0], n[1], n[2]}};
}

Intrinsics sinusCamera() {
    const std::vector<double> numbers = numbersIn(sinusFile("camera_intrinsics_per_view"));
    return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3)};
}

/// Pixels; the method's own equation, not the projector's.
Eigen::Vector2d pinhole(const FramePose& pose, const Eigen::Vector3d& point) {
    const Eigen::Vector3d seen = pose.turn.conjugate() * (point - pose.eye);
    static const Intrinsics camera = sinusCamera();
    return {camera.fx * seen.x() / seen.z() + camera.cx, camera.fy * seen.y() / seen.z() + camera.cy};
}

Projector projectorOf(const FramePose& pose) {
    Projector projector;
    projector.kind = ProjectorKind::Perspective;
    projector.intrinsics = sinusCamera();
    projector.pose.linear() =
        pose.turn.toRotationMatrix() * Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix();
    projector.pose.translation() = pose.eye;
    return projector;
}

/// The points, joined to the surface that the first frame sees.
TriangleMesh sinusSurface(const FramePose& first) {
    constexpr float longest = 260; // pixels; longer sides bridge what no point was found in
    TriangleMesh mesh;
    cv::Subdiv2D triangulation(cv::Rect(0, 0, 1920, 1080));
    std::map<std::pair<float, float>, std::uint32_t> vertexAt;
    for (const Eigen::Vector3d& point : reconstructedPoints()) {
        const Eigen::Vector2f place = pinhole(first, point).cast<float>();
        if (place.x() < 1 || place.y() < 1 || place.x() > 1918 || place.y() > 1078) continue;
        const auto number = static_cast<std::uint32_t>(mesh.vertices.size());
        if (!vertexAt.emplace(std::pair(place.x(), place.y()), number).second) continue;
        mesh.vertices.push_back(point);
        triangulation.insert(cv::Point2f(place.x(), place.y()));
    }
    std::vector<cv::Vec6f> triangles;
    triangulation.getTriangleList(triangles);
    for (const cv::Vec6f& t : triangles) {
        const std::array<Eigen::Vector2f, 3> places{Eigen::Vector2f(t[0], t[1]), Eigen::Vector2f(t[2], t[3]),
                                                    Eigen::Vector2f(t[4], t[5])};
        Triangle triangle;
        bool isKept = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto found = vertexAt.find({places[i].x(), places[i].y()});
            isKept = isKept && found != vertexAt.end() && (places[i] - places[(i + 1) % 3]).norm() < longest;
            if (found != vertexAt.end()) triangle[i] = found->second;
        }
        if (isKept) mesh.triangles.push_back(triangle);
    }
    return mesh;
}

/// How well two series of numbers go together, −1 to 1.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto centred = [](const std::vector<double>& values) {
        const Eigen::Map<const Eigen::ArrayXd> all(values.data(), Eigen::Index(values.size()));
        return Eigen::ArrayXd(all - all.mean());
    };
    const Eigen::ArrayXd x = centred(a), y = centred(b);
    return (x * y).sum() / std::sqrt(x.square().sum() * y.square().sum());
}

TEST(SinusFrames, WhatOneCameraProjectsTheNextOneSees) {
    ESM_SKIP_WITHOUT(sinusFile("motion.yaml"));
    const FramePose first = framePose(0), second = framePose(17); // frames 4584 and 4601
    const TriangleMesh mesh = sinusSurface(first);
    ASSERT_GT(mesh.triangles.size(), 900U);
    TextureLayer layer;
    layer.photo = loadPhoto(sinusFile("00004584.jpg"));
    layer.projector = projectorOf(first);
    layer.projector.occlusion = false;
    const Atlas atlas = packAtlas(mesh, {1024, 1, 2});
    const std::vector<Image> pages = composite(mesh, atlas, {layer}, baseColour);
    const auto next = loadPhoto(sinusFile("00004601.jpg"));
    std::vector<double> projected, seen, seenByTheFirst;
    forEachTexelInside(mesh, atlas, pages, [&](const Eigen::Vector3d& point, const Colour& colour, auto) {
        const Eigen::Vector2d place = pinhole(second, point), unmoved = pinhole(first, point);
        if (place.minCoeff() < 0 || place.x() >= 1920 || place.y() >= 1080) return;
        projected.push_back(colour[1]);
        seen.push_back(pixelAt(next->image, int(place.x()), int(place.y()))[1]);
        seenByTheFirst.push_back(pixelAt(next->image, int(unmoved.x()), int(unmoved.y()))[1]);
    });
    EXPECT_GT(projected.size(), 500000U);
    EXPECT_GT(correlation(projected, seen), 0.8);
    EXPECT_LT(correlation(projected, seenByTheFirst), 0.5) << "the cameras stand apart";
}

} // namespace
} // namespace esm::test
