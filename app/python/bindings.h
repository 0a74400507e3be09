#pragma once

#include <pybind11/pybind11.h>

namespace esm::python {

/// Lets the core's exceptions come out as those of Python.
void addErrors();

// Each adds a part of the module `esm`.
void addTissue(pybind11::module_& module);
void addProject(pybind11::module_& module);
void addSimulation(pybind11::module_& module);
void addMeasuring(pybind11::module_& module);

} // namespace esm::python
