#pragma once

#include <pybind11/pybind11.h>

/// Each adds a part of the module `esm` for Python.
namespace esm::python {

void addErrors(pybind11::module_& module);
void addTissue(pybind11::module_& module);
void addProject(pybind11::module_& module);
void addSimulation(pybind11::module_& module);
void addMeasuring(pybind11::module_& module);

} // namespace esm::python
