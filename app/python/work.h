#pragma once

#include "angiopose/observer.h"

#include <pybind11/pybind11.h>

#include <string>

namespace angiopose::python {

/// Calls `observe(progress)`, which may be None, from work that runs without Python's lock; Ctrl+C ends the work too.
/// What it raises comes out of the work. `observe` must live as long as the observer.
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

/// The result of work that leaves Python to other threads meanwhile.
template <class Work>
auto withoutLock(const Work& work)
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
