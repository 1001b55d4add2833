#include "angiopose/options.h"

#include "app/python/fixed.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

/// Sets an option from a Python value: True and False become "on" and "off".
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

/// Read-only dict; settings are changed with `set`.
py::object fixedDict(const std::map<std::string, std::string>& values)
{
    return py::module_::import("types").attr("MappingProxyType")(py::cast(values));
}

py::str textOf(const RegistrationOptions& options)
{
    return py::str("RegistrationOptions({!r}, locks={!r}, **{!r})")
        .format(options.method, fixedList(options.locks), py::cast(options.values));
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
        .def_readwrite("method", &RegistrationOptions::method, "the id of one of methods()")
        .def_property(
            "values", [](const RegistrationOptions& options) { return fixedDict(options.values); },
            assign<&RegistrationOptions::values>(), "settings as texts, by key; read-only: see set")
        .def_property("locks", asTuple<&RegistrationOptions::locks>(), assign<&RegistrationOptions::locks>(),
                      "degrees of freedom that are kept")
        .def(
            "set",
            [](const py::object& self, const std::string& key, const py::object& value) {
                setOption(self.cast<RegistrationOptions&>(), key, value);
                return self;
            },
            py::arg("key"), py::arg("value"),
            "A number, True or False, or a choice by name; returns the options, so that calls can follow one another.")
        .def("__copy__", [](const RegistrationOptions& options) { return options; })
        .def("__repr__", &textOf);
    bindFixed<RegistrationOptions>(module, "_FixedOptions")
        .def("set",
             [](const Fixed<RegistrationOptions>&, const std::string& key, const py::object&) { refuseToSet(key); });

    py::class_<OptionInfo>(module, "OptionInfo", "One setting of a method.")
        .def_readonly("key", &OptionInfo::key, "as on the command line")
        .def_readonly("unit", &OptionInfo::unit, "\"px\", \"mm\", a degree sign or empty")
        .def_readonly("help", &OptionInfo::help, "the effect, one sentence")
        .def_readonly("min", &OptionInfo::min, "least number")
        .def_readonly("max", &OptionInfo::max, "largest number")
        .def_property_readonly("choices", asTuple<&OptionInfo::choices>(), "not empty: the value is one of these")
        .def_readonly("defaultValue", &OptionInfo::defaultValue, "as a text");
    py::class_<MethodInfo>(module, "MethodInfo", "One method of registration.")
        .def_readonly("id", &MethodInfo::id, "for RegistrationOptions")
        .def_readonly("label", &MethodInfo::label, "what it is called")
        .def_readonly("summary", &MethodInfo::summary, "what it minimises, its source")
        .def_property_readonly("options", asTuple<&MethodInfo::options>(), "what can be set");
    module.def("methods", &methods, "Every method, the default first.");
}

}   // namespace angiopose::python
