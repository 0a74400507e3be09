#include "tests/benchmarks/bare_composition.h"

#include "core/texture/photo/photo_sampler.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace benchmarks {

namespace {

using esm::Image;

void readBare(const Image& picture, double x, double y, float* colour) {
    x = std::clamp(x - 0.5, 0.0, picture.width - 1.0);
    y = std::clamp(y - 0.5, 0.0, picture.height - 1.0);
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, picture.width - 1), bottom = std::min(top + 1, picture.height - 1);
    const auto u = static_cast<float>(x - left), v = static_cast<float>(y - top);
    const std::uint8_t *a = picture.at(left, top), *b = picture.at(right, top), *c = picture.at(left, bottom),
                       *d = picture.at(right, bottom);
    for (int channel = 0; channel < 3; ++channel) {
        const auto value = [&](const std::uint8_t* pixel) { return static_cast<float>(pixel[channel]); };
        const float above = value(a) + u * (value(b) - value(a));
        const float below = value(c) + u * (value(d) - value(c));
        colour[channel] = above + v * (below - above);
    }
}

/// Takes a page's pixels to those of a photo.
using PageToPhoto = Eigen::Matrix<double, 2, 3>;

void layTexel(const PageToPhoto& toPhoto, const esm::TextureLayer& layer, const BarePyramid& photo,
              double depth, int x, int y, Image& page) {
    const double column = toPhoto(0, 0) * (x + 0.5) + toPhoto(0, 1) * (y + 0.5) + toPhoto(0, 2);
    const double row = toPhoto(1, 0) * (x + 0.5) + toPhoto(1, 1) * (y + 0.5) + toPhoto(1, 2);
    const double inside =
        std::min(std::min(column, row), std::min(photo[0].width - column, photo[0].height - row));
    if (!(inside > 0)) return;
    const auto weight = static_cast<float>(layer.opacity * std::min(1.0, inside / layer.blendPixels));
    const auto fine = std::min(static_cast<std::size_t>(depth), photo.size() - 2);
    const auto share = static_cast<float>(depth - static_cast<double>(fine));
    const double scale = std::ldexp(1.0, -static_cast<int>(fine));
    float finer[3], coarser[3];
    readBare(photo[fine], column * scale, row * scale, finer);
    readBare(photo[fine + 1], column * scale / 2, row * scale / 2, coarser);
    std::uint8_t* pixel = page.at(x, y);
    for (int channel = 0; channel < 3; ++channel) {
        const float colour = finer[channel] + share * (coarser[channel] - finer[channel]);
        const auto beneath = static_cast<float>(pixel[channel]);
        pixel[channel] = static_cast<std::uint8_t>(beneath + weight * (colour - beneath) + 0.5F);
    }
}

} // namespace

BarePyramid barePyramid(const Image& photo) {
    BarePyramid pyramid{photo};
    while (pyramid.back().width > 1 || pyramid.back().height > 1)
        pyramid.push_back(esm::halved(pyramid.back()));
    return pyramid;
}

void layBare(const esm::TriangleMesh& mesh, const esm::Atlas& atlas, const esm::TextureLayer& layer,
             const BarePyramid& photo, Image& page) {
    const Eigen::Matrix4d matrix = esm::photoMatrix(layer.projector, {photo[0].width, photo[0].height});
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& patch = atlas.corners[i];
        Eigen::Matrix3d place, corners;
        Eigen::AlignedBox2d box;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto column = static_cast<Eigen::Index>(corner);
            corners.col(column) = mesh.vertices[mesh.triangles[i][corner]];
            place.col(column) = patch[corner].homogeneous();
            box.extend(patch[corner]);
        }
        const Eigen::Vector3d normal =
            (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
        if (!(normal.dot(layer.projector.pose.linear().col(2)) > 0)) continue;
        const Eigen::Matrix3d weights = place.inverse();
        const PageToPhoto toPhoto = matrix.topRows<2>() * corners.colwise().homogeneous() * weights;
        const Eigen::Matrix2d perTexel = toPhoto.leftCols<2>();
        const double depth =
            std::max(0.0, std::log2(Eigen::JacobiSVD<Eigen::Matrix2d>(perTexel).singularValues()[0]));
        for (int y = static_cast<int>(box.min().y()); y <= static_cast<int>(box.max().y()); ++y) {
            const Eigen::Vector3d row = weights * Eigen::Vector3d(0.5, y + 0.5, 1);
            for (int x = static_cast<int>(box.min().x()); x <= static_cast<int>(box.max().x()); ++x)
                if ((row + x * weights.col(0)).minCoeff() >= 0)
                    layTexel(toPhoto, layer, photo, depth, x, y, page);
        }
    }
}

} // namespace benchmarks
