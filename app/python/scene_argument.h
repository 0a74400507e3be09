#pragma once

#include "core/model/scene.h"

#include <pybind11/pybind11.h>

namespace esm::python {

/// A scene as in `docs/command-line.md`, given as a dictionary or as JSON. @throws InvalidModel
Scene sceneFrom(const pybind11::object& given);

} // namespace esm::python
