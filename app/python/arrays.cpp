#include "app/python/arrays.h"

#include "core/dynamics/given_loads.h"
#include "core/support/errors.h"

namespace esm::python {

py::array_t<double> copiedPoints(const std::vector<Eigen::Vector3d>& points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
    double* place = array.mutable_data();
    for (const Eigen::Vector3d& point : points)
        place = std::copy_n(point.data(), 3, place);
    return array;
}

namespace {

using NodeNumbers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// NumPy would cut 1.9 down to 1 without a word; to it an empty list is one of real numbers.
NodeNumbers wholeNumbers(const py::object& given) {
    const auto numbers = py::array::ensure(given);
    const bool areWhole =
        numbers && (numbers.size() == 0 || numbers.dtype().kind() == 'i' || numbers.dtype().kind() == 'u');
    if (!areWhole) throw InvalidModel("nodes are whole numbers, counted from 0, as [7]");
    return numbers;
}

} // namespace

std::vector<std::pair<std::uint32_t, Eigen::Vector3d>>
vectorsByNode(const char* what, const py::object& given, const Vectors3& vectors, std::size_t nodeCount) {
    const NodeNumbers nodes = wholeNumbers(given);
    if (nodes.ndim() != 1 || vectors.ndim() != 2 || vectors.shape(0) != nodes.shape(0) ||
        vectors.shape(1) != 3)
        throw InvalidModel("nodes are given as a list, as [7], and a " + std::string(what) +
                           " for each as a row of three numbers, as [[0, 0, -1]]");
    std::vector<std::pair<std::uint32_t, Eigen::Vector3d>> result;
    for (py::ssize_t i = 0; i < nodes.shape(0); ++i) {
        const Eigen::Vector3d vector(vectors.at(i, 0), vectors.at(i, 1), vectors.at(i, 2));
        result.emplace_back(static_cast<std::uint32_t>(nodes.at(i)),
                            givenVector(what, nodes.at(i), vector, nodeCount));
    }
    return result;
}

} // namespace esm::python
