#include "core/texture/layers/lit_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>

namespace esm {

namespace {

/// A triangle in the photo's plane.
struct View {
    std::array<Eigen::Vector2d, 3> corners; ///< pixels
    Eigen::AlignedBox2d box;
    double nearest, farthest; ///< m from the photo's plane or the eye
    bool isWhole;             ///< all of it lies before the eye
    bool isBehind;            ///< none of it lies before the eye or the plane: it hides nothing
};

View viewOf(const TriangleMesh& mesh, const Triangle& triangle, const Eigen::Matrix4d& matrix) {
    View view{};
    Eigen::Matrix<double, 4, 3> seen;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        seen.col(column) = matrix * mesh.vertices[triangle[i]].homogeneous();
        view.corners[i] = seen.col(column).head<2>() / seen(2, column);
        view.box.extend(view.corners[i]);
    }
    view.nearest = seen.row(3).minCoeff();
    view.farthest = seen.row(3).maxCoeff();
    view.isWhole = seen.row(2).minCoeff() > 0 && view.box.min().allFinite() && view.box.max().allFinite();
    view.isBehind = view.farthest <= 0;
    return view;
}

/// Whether a line along one of a's sides has all of a on one side and all of b on the other.
bool isParted(const View& a, const View& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d &start = a.corners[i], side = a.corners[(i + 1) % 3] - start;
        const Eigen::Vector2d across(-side.y(), side.x());
        const double own = across.dot(a.corners[(i + 2) % 3] - start);
        bool isBeyond = true;
        for (const Eigen::Vector2d& corner : b.corners)
            isBeyond = isBeyond && across.dot(corner - start) * own <= 0;
        if (own != 0 && isBeyond) return true;
    }
    return false;
}

bool overlap(const View& a, const View& b) {
    return a.box.intersects(b.box) && !isParted(a, b) && !isParted(b, a);
}

/// The views that may hide something, by the cells of a grid over all of them.
class ViewGrid {
public:
    explicit ViewGrid(const std::vector<View>& views) : m_views(views) {
        for (const View& view : views)
            if (!view.isBehind) m_box.extend(view.box);
        m_cells = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(views.size()) / 2)), 1, 512);
        m_perCell = (m_box.sizes() / m_cells).cwiseMax(1e-300);
        m_members.resize(static_cast<std::size_t>(m_cells) * static_cast<std::size_t>(m_cells));
        for (std::uint32_t i = 0; i < views.size(); ++i)
            if (!views[i].isBehind)
                forEachCell(views[i], [&](std::size_t cell) { m_members[cell].push_back(i); });
    }

    bool isHiddenByAny(std::uint32_t triangle) const {
        const View& view = m_views[triangle];
        bool isHidden = false;
        const auto hides = [&](std::uint32_t other) {
            return other != triangle && m_views[other].nearest < view.farthest &&
                   overlap(view, m_views[other]);
        };
        forEachCell(view, [&](std::size_t cell) {
            const auto& members = m_members[cell];
            isHidden = isHidden || std::any_of(members.begin(), members.end(), hides);
        });
        return isHidden;
    }

private:
    template<typename Visit> void forEachCell(const View& view, const Visit& visit) const {
        const auto cell = [&](const Eigen::Vector2d& place, int axis) {
            return static_cast<int>(
                std::clamp((place[axis] - m_box.min()[axis]) / m_perCell[axis], 0.0, m_cells - 1.0));
        };
        for (int y = cell(view.box.min(), 1); y <= cell(view.box.max(), 1); ++y)
            for (int x = cell(view.box.min(), 0); x <= cell(view.box.max(), 0); ++x)
                visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(m_cells) +
                      static_cast<std::size_t>(x));
    }

    const std::vector<View>& m_views;
    Eigen::AlignedBox2d m_box;
    Eigen::Vector2d m_perCell;
    int m_cells = 1;
    std::vector<std::vector<std::uint32_t>> m_members;
};

} // namespace

std::vector<std::uint8_t> certainlyLit(const TriangleMesh& mesh, const Projector& projector,
                                       PhotoSize photo) {
    std::vector<std::uint8_t> lit(mesh.triangles.size(), 0);
    const Eigen::Matrix4d matrix = photoMatrix(projector, photo);
    std::vector<View> views;
    views.reserve(lit.size());
    for (const Triangle& triangle : mesh.triangles)
        views.push_back(viewOf(mesh, triangle, matrix));
    const auto isUnclear = [](const View& view) { return !view.isWhole && !view.isBehind; };
    if (std::any_of(views.begin(), views.end(), isUnclear)) return lit;
    const ViewGrid grid(views);
    tbb::parallel_for(std::size_t{0}, lit.size(), [&](std::size_t i) {
        lit[i] = !views[i].isBehind && !grid.isHiddenByAny(static_cast<std::uint32_t>(i)) ? 1 : 0;
    });
    return lit;
}

} // namespace esm
