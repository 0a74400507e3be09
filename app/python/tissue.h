#pragma once

#include "core/dynamics/contact/touched_surface.h"
#include "core/exchange/package/packaged_tissue.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace esm::python {

/// What Python calls a tissue: that of a package, or what a project was evaluated to. Arrays in Python share
/// its memory, so it never changes.
struct Tissue {
    std::string name;
    std::shared_ptr<const TissueModel> model;
    std::shared_ptr<const TriangleMesh> mesh;
    std::vector<SpringValues> springValues; ///< of the model
    std::optional<MeasuredStepping> stepping;
    std::vector<PartPressure> pressures; ///< that press on its parts from within

    std::size_t nodeCount() const { return model->mass.size(); }
};

Tissue tissueOf(PackagedTissue package);

/// A dictionary: integrator, dt (s) and precision.
pybind11::dict dictionaryOf(const Stepping& stepping);

} // namespace esm::python
