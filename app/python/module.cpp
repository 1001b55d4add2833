#include "angiopose/error.h"
#include "angiopose/version.h"
#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

void raise(const py::handle& type, const Error& error)
{
    const py::object raised = type(error.what());
    raised.attr("id") = error.id();
    PyErr_SetObject(type.ptr(), raised.ptr());
}

}   // namespace

void bindErrors(py::module_& module)
{
    py::class_<Message>(module, "Message", "Message for the user; `id` remains stable when the wording changes.")
        .def_readonly("id", &Message::id, "For programs; \"text.plain\" if the sentence has no id of its own.")
        .def_readonly("text", &Message::text, "The English sentence.")
        .def_property_readonly("arguments", asTuple<&Message::arguments>(),
                               "Arguments of the sentence: names, and numbers with their unit.")
        .def("__str__", [](const Message& message) { return message.text; })
        .def("__repr__", [](const Message& message) { return "<Message " + message.id + ": " + message.text + ">"; });

    // Intentionally leaked, because the interpreter may have ended when static objects are destroyed.
    static const py::handle errorType = py::exception<Error>(module, "Error", PyExc_RuntimeError).release();
    static const py::handle stoppedType = py::exception<Stopped>(module, "Stopped", errorType).release();
    errorType.attr("__doc__") =
        "An operation failed: the message names the file or value, the problem and the remedy; `id` is for programs.";
    stoppedType.attr("__doc__") = "The observer stopped an operation that has no partial result: reading, tracing.";
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(thrown);
        } catch (const Stopped& stopped) {
            raise(stoppedType, stopped);
        } catch (const Error& error) {
            raise(errorType, error);
        }
    });
}

}   // namespace angiopose::python

PYBIND11_MODULE(_angiopose, module)
{
    using namespace angiopose::python;
    module.attr("__name__") = "angiopose";   // makes the classes appear in the public module
    module.attr("__version__") = angiopose::version();
    bindErrors(module);
    bindGeometry(module);
    bindVessels(module);
    bindAngiograms(module);
    bindVolumes(module);
    bindOptions(module);
    bindDeformation(module);
    bindRegistration(module);
    bindCases(module);
}
