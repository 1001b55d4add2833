#include "angiopose/options.h"

#include "app/python/read_only.h"
#include "app/python/work.h"

namespace angiopose::python {
namespace {

/// Sets an option from a Python value; True and False become "on" and "off".
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

/// Returns a read-only dict; settings are changed with `set`.
py::object readOnlyDict(const std::map<std::string, std::string>& values)
{
    return py::module_::import("types").attr("MappingProxyType")(py::cast(values));
}

py::str textOf(const RegistrationOptions& options)
{
    return py::str("RegistrationOptions({!r}, locks={!r}, **{!r})")
        .format(options.method, readOnlyTuple(options.locks), py::cast(options.values));
}

}   // namespace

void bindOptions(py::module_& module)
{
    py::class_<RegistrationOptions>(module, "RegistrationOptions",
                                    "Method of a registration and its settings, with the keys of "
                                    "`methods()`.\nSettings that are not set have their defaults.")
        .def(py::init(&optionsOf), py::arg("method") = "angiopose", py::arg("locks") = std::vector<std::string>(),
             "locks: degrees of freedom to lock: right, up, along-ray, roll, lao-rao, cra-cau. Settings by "
             "name:\nRegistrationOptions(\"angiopose\", maxIterations=40, search=True).")
        .def_readwrite("method", &RegistrationOptions::method, "the id of one of methods()")
        .def_property(
            "values", [](const RegistrationOptions& options) { return readOnlyDict(options.values); },
            assign<&RegistrationOptions::values>(), "settings as strings, by key; read-only: see set")
        .def_property("locks", asTuple<&RegistrationOptions::locks>(), assign<&RegistrationOptions::locks>(),
                      "locked degrees of freedom")
        .def(
            "set",
            [](const py::object& self, const std::string& key, const py::object& value) {
                setOption(self.cast<RegistrationOptions&>(), key, value);
                return self;
            },
            py::arg("key"), py::arg("value"),
            "Sets a number, True or False, or a choice by name; returns the options, so calls can be chained.")
        .def("__copy__", [](const RegistrationOptions& options) { return options; })
        .def("__repr__", &textOf);
    bindReadOnly<RegistrationOptions>(module, "_FixedOptions")
        .def("set", [](const ReadOnly<RegistrationOptions>&, const std::string& key, const py::object&) {
            throwReadOnlyError(key);
        });

    py::class_<OptionInfo>(module, "OptionInfo", "One setting of a method.")
        .def_readonly("key", &OptionInfo::key, "name as on the command line")
        .def_readonly("unit", &OptionInfo::unit, "\"px\", \"mm\", a degree sign or empty")
        .def_readonly("help", &OptionInfo::help, "effect, in one sentence")
        .def_readonly("min", &OptionInfo::min, "minimum value")
        .def_readonly("max", &OptionInfo::max, "maximum value")
        .def_property_readonly("choices", asTuple<&OptionInfo::choices>(), "allowed values, if not empty")
        .def_readonly("defaultValue", &OptionInfo::defaultValue, "as a text");
    py::class_<MethodInfo>(module, "MethodInfo", "One registration method.")
        .def_readonly("id", &MethodInfo::id, "id for RegistrationOptions")
        .def_readonly("label", &MethodInfo::label, "display name")
        .def_readonly("summary", &MethodInfo::summary, "objective and source")
        .def_property_readonly("options", asTuple<&MethodInfo::options>(), "available settings");
    module.def("methods", &methods, "All methods, the default first.");
}

}   // namespace angiopose::python
