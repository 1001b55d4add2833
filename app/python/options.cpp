#include "angiopose/options.h"

#include "app/python/arrays.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

/// A setting as Python gives it: True and False are "on" and "off".
void setOption(RegistrationOptions& options, const std::string& key, const py::handle& value)
{
    if (py::isinstance<py::bool_>(value)) {
        options.set(key, value.cast<bool>() ? "on" : "off");
    } else if (py::isinstance<py::str>(value)) {
        options.set(key, value.cast<std::string>());
    } else {
        options.set(key, value.cast<double>());
    }
}

RegistrationOptions optionsOf(const std::string& method, const std::vector<std::string>& locks,
                              const py::kwargs& values)
{
    RegistrationOptions options{method, {}, locks};
    for (const auto& [key, value] : values) {
        setOption(options, key.cast<std::string>(), value);
    }
    return options;
}

}   // namespace

void bindOptions(py::module_& module)
{
    py::class_<RegistrationOptions>(
        module, "RegistrationOptions",
        "Which method solves a registration, and its settings: those of `methods()`, by key.\n"
        "What is not set has its default.")
        .def(py::init(&optionsOf), py::arg("method") = "angiopose", py::arg("locks") = std::vector<std::string>(),
             "locks: degrees of freedom kept: right, up, along-ray, roll, lao-rao, cra-cau. Settings by name:\n"
             "RegistrationOptions(\"angiopose\", maxIterations=40, search=True).")
        .def_readwrite("method", &RegistrationOptions::method)
        .def_readwrite("values", &RegistrationOptions::values, "settings as texts, by key")
        .def_readwrite("locks", &RegistrationOptions::locks)
        .def("set", &setOption, py::arg("key"), py::arg("value"), "A number, True or False, or a choice by name.");

    py::class_<OptionInfo>(module, "OptionInfo", "One setting of a method.")
        .def_readonly("key", &OptionInfo::key)
        .def_readonly("unit", &OptionInfo::unit, "\"px\", \"mm\", a degree sign or empty")
        .def_readonly("help", &OptionInfo::help)
        .def_readonly("min", &OptionInfo::min)
        .def_readonly("max", &OptionInfo::max)
        .def_readonly("choices", &OptionInfo::choices, "not empty: the value is one of these")
        .def_readonly("defaultValue", &OptionInfo::defaultValue);
    py::class_<MethodInfo>(module, "MethodInfo", "One method of registration.")
        .def_readonly("id", &MethodInfo::id)
        .def_readonly("label", &MethodInfo::label)
        .def_readonly("summary", &MethodInfo::summary, "what it minimises, its source")
        .def_readonly("options", &MethodInfo::options);
    module.def("methods", &methods, "Every method, the default first.");
}

}   // namespace angiopose::python
