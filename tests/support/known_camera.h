#pragma once

#include "core/texture/projection/projector.h"
#include "tests/support/shared_data.h"

#include <fstream>

inline std::filesystem::path knownCameraFolder() {
    return sharedData("images/synthetic-liver-H07");
}

/// A matrix of a text file, row by row.
template<int size> Eigen::Matrix<double, size, size> knownMatrix(const char* file) {
    std::ifstream text(knownCameraFolder() / file);
    Eigen::Matrix<double, size, size> matrix;
    for (int i = 0; i < size * size; ++i)
        text >> matrix(i / size, i % size);
    return matrix;
}

/// The camera that took the picture of the liver H07, as a projector of the organ in metres: x_camera =
/// (camera to world)⁻¹ · (model to world) · x, in millimetres, with y down and z forwards.
inline esm::Projector knownCamera() {
    const Eigen::Matrix4d toCamera =
        knownMatrix<4>("camera_to_world.txt").inverse() * knownMatrix<4>("model_to_world.txt");
    Eigen::Isometry3d pose = Eigen::Isometry3d(toCamera).inverse();
    pose.linear() *= Eigen::Vector3d(1, -1, -1).asDiagonal();
    pose.translation() /= 1000;
    const Eigen::Matrix3d k = knownMatrix<3>("calib.left.intrinsics.txt");
    esm::Projector projector;
    projector.pose = pose;
    projector.kind = esm::ProjectorKind::Perspective;
    projector.intrinsics = esm::Intrinsics{k(0, 0), k(1, 1), k(0, 2), k(1, 2)};
    return projector;
}
