#include "core/samples/implicit_surface.h"
#include "core/support/angles.h"

#include <algorithm>
#include <cmath>

namespace esm {

namespace {

constexpr double fullTurn = 2 * pi;
constexpr int stations = 300; ///< at which the body is measured along its axis

/// The first place from inside to outside along a ray, m: steps of 2 mm until it is outside, then halving, to
/// 2 nm. A hollow narrower than a step is passed over.
double depthAlong(const Shape& shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
    double inside = 0, outside = 0.002;
    while (shape(origin + outside * direction) < 0) {
        inside = outside;
        outside += 0.002;
    }
    for (int i = 0; i < 20; ++i) {
        const double middle = (inside + outside) / 2;
        (shape(origin + middle * direction) < 0 ? inside : outside) = middle;
    }
    return outside;
}

struct Section {
    Eigen::Vector3d centre, right, up;
};

/// Rings across an axis instead of marching cubes: vertices lie evenly by construction, their number is
/// chosen by the spacing, and no slivers come up where a grid cuts the surface at a corner. It asks that
/// every section be seen whole from the axis, which organs of one body with a clear long way are.
class BodyAround {
public:
    BodyAround(const Shape& shape, const Axis& axis, double spacing)
        : m_shape(shape), m_axis(axis), m_spacing(spacing) {
        m_begin = end(0);
        m_end = end(1);
    }

    TriangleMesh mesh() {
        const std::vector<double> places = ringPlaces();
        m_mesh.vertices.push_back(m_axis.at(m_begin));
        std::vector<std::uint32_t> previous{0};
        for (const double place : places) {
            std::vector<std::uint32_t> ring = addRing(place);
            stitch(previous, ring);
            previous = std::move(ring);
        }
        const auto last = static_cast<std::uint32_t>(m_mesh.vertices.size());
        m_mesh.vertices.push_back(m_axis.at(m_end));
        stitch(previous, {last});
        return std::move(m_mesh);
    }

private:
    /// Where the axis enters the body, coming from its parameter 0 or 1.
    double end(double from) const {
        const double step = from < 0.5 ? 0.001 : -0.001;
        double outside = from;
        while (m_shape(m_axis.at(outside + step)) > 0)
            outside += step;
        double inside = outside + step;
        for (int i = 0; i < 20; ++i) {
            const double middle = (inside + outside) / 2;
            (m_shape(m_axis.at(middle)) > 0 ? outside : inside) = middle;
        }
        return inside;
    }

    Section sectionAt(double place) const {
        constexpr double step = 1e-4;
        const Eigen::Vector3d along = (m_axis.at(place + step) - m_axis.at(place - step)).normalized();
        const Eigen::Vector3d right = along.cross(m_axis.side).normalized();
        return {m_axis.at(place), right, right.cross(along)};
    }

    Eigen::Vector3d direction(const Section& section, double turn) const {
        return std::cos(turn * fullTurn) * section.right - std::sin(turn * fullTurn) * section.up;
    }

    double meanRadius(double place) const {
        constexpr int rays = 12;
        const Section section = sectionAt(place);
        double sum = 0;
        for (int i = 0; i < rays; ++i)
            sum += depthAlong(m_shape, section.centre, direction(section, double(i) / rays));
        return sum / rays;
    }

    /// Axis parameters at equal distances along the surface. Where the body widens, the way along the surface
    /// is longer than that along the axis: the length of the profile, (along, change of the mean radius), is
    /// measured and divided evenly. Rows are √¾ of the spacing apart, as in equilateral triangles.
    std::vector<double> ringPlaces() const {
        const double width = (m_end - m_begin) / stations;
        std::vector<double> lengths{0};
        double radiusBefore = 0;
        for (int i = 1; i <= stations; ++i) {
            const double place = m_begin + i * width;
            const double radius = i < stations ? meanRadius(place) : 0;
            const double along = (m_axis.at(place) - m_axis.at(place - width)).norm();
            lengths.push_back(lengths.back() + std::hypot(along, radius - radiusBefore));
            radiusBefore = radius;
        }
        const double rowHeight = m_spacing * std::sqrt(0.75);
        const int rows = std::max(3, static_cast<int>(std::lround(lengths.back() / rowHeight)));
        std::vector<double> places;
        for (int row = 1, i = 1; row < rows; ++row) {
            const double wanted = lengths.back() * row / rows;
            while (lengths[static_cast<std::size_t>(i)] < wanted)
                ++i;
            const double before = lengths[static_cast<std::size_t>(i - 1)],
                         after = lengths[static_cast<std::size_t>(i)];
            places.push_back(m_begin + (i - 1 + (wanted - before) / (after - before)) * width);
        }
        return places;
    }

    std::vector<std::uint32_t> addRing(double place) {
        const Section section = sectionAt(place);
        const double circumference = fullTurn * meanRadius(place);
        const int count = std::max(5, static_cast<int>(std::lround(circumference / m_spacing)));
        std::vector<std::uint32_t> ring;
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector3d outwards = direction(section, double(i) / count);
            ring.push_back(static_cast<std::uint32_t>(m_mesh.vertices.size()));
            m_mesh.vertices.emplace_back(section.centre +
                                         depthAlong(m_shape, section.centre, outwards) * outwards);
        }
        return ring;
    }

    /// Joins two rings of any counts, going round both at the same pace: always on where the middle of the
    /// next side lies less far round, (i + ½) / a against (j + ½) / b, compared in whole numbers. An end of
    /// the body is a ring of one.
    void stitch(const std::vector<std::uint32_t>& first, const std::vector<std::uint32_t>& second) {
        const std::size_t a = first.size(), b = second.size();
        const std::size_t steps = (a > 1 ? a : 0) + (b > 1 ? b : 0);
        for (std::size_t step = 0, i = 0, j = 0; step < steps; ++step) {
            // The ring whose next vertex comes first around takes a step.
            const bool advanceFirst =
                b == 1 || (a > 1 && i < a && (j >= b || (2 * i + 1) * b <= (2 * j + 1) * a));
            if (advanceFirst) {
                m_mesh.triangles.push_back({first[i % a], first[(i + 1) % a], second[j % b]});
                ++i;
            } else {
                m_mesh.triangles.push_back({first[i % a], second[(j + 1) % b], second[j % b]});
                ++j;
            }
        }
    }

    const Shape& m_shape;
    const Axis& m_axis;
    double m_spacing;
    double m_begin = 0, m_end = 1; ///< axis parameters at the body's ends
    TriangleMesh m_mesh;
};

} // namespace

TriangleMesh meshAround(const Shape& shape, const Axis& axis, double spacing) {
    TriangleMesh mesh = BodyAround(shape, axis, spacing).mesh();
    drawOnto(shape, 40, mesh);
    return mesh;
}

} // namespace esm
