#pragma once

#include "app/python/arrays.h"

// What objects give away as copies cannot be changed in Python: a change would be lost without a word.
namespace angiopose::python {

/// A T that belongs to another object: like T, but its attributes cannot be set. Copies of it can be changed.
template <class T>
struct Fixed : T {
    explicit Fixed(T value) : T(std::move(value)) {}
};

[[noreturn]] inline void refuseToSet(const std::string& name)
{
    throw py::attribute_error("setting '" + name +
                              "' of what another object gave away would be lost: change a copy.copy() of it and "
                              "assign that");
}

template <class T>
auto bindFixed(py::module_& module, const char* name)
{
    return py::class_<Fixed<T>, T>(module, name)
        .def("__setattr__",
             [](const Fixed<T>&, const std::string& attribute, const py::object&) { refuseToSet(attribute); });
}

/// A matrix as a read-only array.
template <class Matrix>
py::array fixedArray(const Matrix& matrix)
{
    py::array array = py::cast(matrix);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// … or None.
template <class Matrix>
py::object fixedArray(const std::optional<Matrix>& matrix)
{
    return matrix ? py::object(fixedArray(*matrix)) : py::object(py::none());
}

template <class T>
py::tuple fixedList(const std::vector<T>& values)
{
    py::tuple list(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        list[i] = py::cast(values[i], py::return_value_policy::copy);
    }
    return list;
}

template <class Member>
struct MemberOf;
template <class Class, class Type>
struct MemberOf<Type Class::*> {
    using Owner = Class;
    using Value = Type;
};

/// For def_property: a field that is a list, given away as a tuple.
template <auto Field>
auto asTuple()
{
    return [](const typename MemberOf<decltype(Field)>::Owner& owner) { return fixedList(owner.*Field); };
}

/// … a field that is a matrix, or may be one.
template <auto Field>
auto asArray()
{
    return [](const typename MemberOf<decltype(Field)>::Owner& owner) { return fixedArray(owner.*Field); };
}

/// For the setter beside them.
template <auto Field>
auto assign()
{
    using Member = MemberOf<decltype(Field)>;
    return [](typename Member::Owner& owner, const typename Member::Value& value) { owner.*Field = value; };
}

}   // namespace angiopose::python
