#pragma once

#include "angiopose/observer.h"

#include <pybind11/pybind11.h>

#include <string>

namespace angiopose::python {

/// Returns an observer that calls `observe(progress)` from work that runs without the GIL; `observe` may be None, and
/// Ctrl+C also ends the work. Exceptions of `observe` propagate out of the work. `observe` must outlive the observer.
inline Observer observerOf(pybind11::handle observe)
{
    if (!observe.is_none() && PyCallable_Check(observe.ptr()) == 0) {
        throw pybind11::type_error("observe must be callable with a Progress, or None");
    }
    return [observe](const Progress& progress) {
        const pybind11::gil_scoped_acquire lock;
        if (PyErr_CheckSignals() != 0) {
            throw pybind11::error_already_set();
        }
        if (observe.is_none()) {
            return Verdict::Continue;
        }
        const pybind11::object answer = observe(progress);
        if (answer.is_none()) {
            return Verdict::Continue;
        }
        if (!pybind11::isinstance<Verdict>(answer)) {
            throw pybind11::type_error("observe must return a Verdict or None, not " +
                                       pybind11::repr(answer).cast<std::string>());
        }
        return answer.cast<Verdict>();
    };
}

/// Runs the work without the GIL and returns its result.
template <class Work>
auto withoutGil(const Work& work)
{
    const pybind11::gil_scoped_release unlocked;
    return work();
}

void bindErrors(pybind11::module_& module);
void bindGeometry(pybind11::module_& module);
void bindVessels(pybind11::module_& module);
void bindAngiograms(pybind11::module_& module);
void bindVolumes(pybind11::module_& module);
void bindOptions(pybind11::module_& module);
void bindDeformation(pybind11::module_& module);
void bindRegistration(pybind11::module_& module);
void bindCases(pybind11::module_& module);

}   // namespace angiopose::python
