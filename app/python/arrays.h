#pragma once

#include "core/dynamics/loads.h"

#include <pybind11/numpy.h>

#include <Eigen/Core>

namespace esm::python {

namespace py = pybind11;

/// What a NumPy array shows of memory that lives as long as another Python object: how many rows of how many
/// numbers, and how many bytes one row is behind the other.
struct Rows {
    std::size_t count, width, stride;
};

/// An array that shares the memory and cannot be written to; of one dimension where rows have one number.
/// @param owner keeps the memory alive, and never changes it
template<class Number> py::array sharedArray(const Number* first, const Rows& rows, py::handle owner) {
    const auto signedSize = [](std::size_t size) { return static_cast<py::ssize_t>(size); };
    std::vector<py::ssize_t> shape{signedSize(rows.count)}, strides{signedSize(rows.stride)};
    if (rows.width > 1) {
        shape.push_back(signedSize(rows.width));
        strides.push_back(signedSize(sizeof(Number)));
    }
    py::array_t<Number> array(shape, strides, first, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

/// Of one member of all structs of a list, or of it and those of its kind that follow it.
template<class Number, class Element>
py::array sharedMember(const std::vector<Element>& elements, Number Element::*first, std::size_t width,
                       py::handle owner) {
    const Number* const numbers = elements.empty() ? nullptr : &(elements.front().*first);
    return sharedArray(numbers, {elements.size(), width, sizeof(Element)}, owner);
}

/// Of numbers.
template<class Number> py::array sharedNumbers(const std::vector<Number>& numbers, py::handle owner) {
    return sharedArray(numbers.data(), {numbers.size(), 1, sizeof(Number)}, owner);
}

/// Of points, triangles or tetrahedra, a row for each.
template<class Element> py::array sharedRows(const std::vector<Element>& elements, py::handle owner) {
    const auto* const first =
        elements.empty() ? static_cast<decltype(elements.front().data())>(nullptr) : elements.front().data();
    return sharedArray(first, {elements.size(), sizeof(Element) / sizeof(*first), sizeof(Element)}, owner);
}

/// A copy, a row for each point.
py::array_t<double> copiedPoints(const std::vector<Eigen::Vector3d>& points);

using Vectors3 = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A vector for each of some nodes. @param what "force", for what is said where they cannot be
/// @throws InvalidModel: other shapes than (n,) and (n, 3), nodes that do not exist, numbers that are none or
/// not whole where nodes are
std::vector<std::pair<std::uint32_t, Eigen::Vector3d>>
vectorsByNode(const char* what, const py::object& nodes, const Vectors3& vectors, std::size_t nodeCount);

} // namespace esm::python
