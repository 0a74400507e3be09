#include "app/python/bindings.h"

#include "core/support/errors.h"

namespace esm::python {

void addErrors() {
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const FileError& error) {
            PyErr_SetString(PyExc_OSError, error.what());
        } catch (const InvalidModel& error) {
            PyErr_SetString(PyExc_ValueError, error.what());
        } catch (const Cancelled&) {
            // Work is cancelled by a signal, whose exception Python has already.
            if (!PyErr_Occurred()) PyErr_SetString(PyExc_KeyboardInterrupt, "cancelled");
        }
    });
}

} // namespace esm::python

PYBIND11_MODULE(esm, module) {
    module.doc() = R"(Organ models of the Elastodynamic Shape Modeler.

    tissue = esm.load_package("liver.glb")         # or esm.load_project("liver.esm").evaluate()
    simulation = esm.Simulation(tissue)
    simulation.set_forces([12], [[0, 0, -1]])      # N
    simulation.step(10)
    simulation.positions()                         # m, a row for each node

Metres, kilograms, seconds, newtons. A file that cannot be read raises OSError, what cannot be done ValueError.)";
    esm::python::addErrors();
    esm::python::addTissue(module);
    esm::python::addProject(module);
    esm::python::addSimulation(module);
    esm::python::addMeasuring(module);
}
