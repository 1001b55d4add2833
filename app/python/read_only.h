#pragma once

#include "angiopose/angiogram.h"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Values that objects return as copies are read-only in Python, because a change to the copy would be silently lost.

namespace angiopose::python {

namespace py = pybind11;

/// Path argument from Python: str, bytes or os.PathLike.
using Path = std::filesystem::path;

/// C-contiguous array of the requested type; other arrays are converted.
template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// Returns a view of values that `owner` holds; no copy. Read-only, because copies of C++ objects share the values.
template <class T>
py::array viewOf(const T* values, const std::vector<py::ssize_t>& shape, const py::handle& owner)
{
    py::array view(py::dtype::of<T>(), shape, values, owner);
    view.attr("flags").attr("writeable") = false;
    return view;
}

template <class T>
py::array viewOf(const std::vector<T>& values, const py::handle& owner)
{
    return viewOf(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Returns an array view of points, one point per row.
template <int Columns>
py::array viewOf(const std::vector<Eigen::Matrix<double, Columns, 1>>& points, const py::handle& owner)
{
    const double* first = points.empty() ? nullptr : points.front().data();
    return viewOf(first, {static_cast<py::ssize_t>(points.size()), Columns}, owner);
}

template <class T>
py::array viewOf(const Image2d<T>& image, const py::handle& owner)
{
    return viewOf(image.pixels.data(), {image.height, image.width}, owner);
}

inline void checkShape(bool isRight, const char* name, const char* shape)
{
    if (!isRight) {
        throw py::value_error(std::string(name) + " must be an array of shape " + shape);
    }
}

template <int Columns>
std::vector<Eigen::Matrix<double, Columns, 1>> pointsOf(const Array<double>& rows, const char* name)
{
    if (rows.size() == 0) {
        return {};
    }
    checkShape(rows.ndim() == 2 && rows.shape(1) == Columns, name, Columns == 3 ? "(N, 3)" : "(M, 2)");
    std::vector<Eigen::Matrix<double, Columns, 1>> points;
    points.reserve(static_cast<std::size_t>(rows.shape(0)));
    for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
        points.emplace_back(rows.data(i, 0));
    }
    return points;
}

/// Converts integers of any type to T. Throws for fractions and for numbers outside the range of T, because conversion
/// would change them.
template <class T>
Array<T> toIntegerArray(const py::object& given, const char* name)
{
    const auto any = py::array::ensure(given);
    if (!any) {
        throw py::error_already_set();
    }
    if (any.size() > 0 && !py::isinstance<py::array_t<T>>(any)) {
        if (std::string_view("iub").find(any.dtype().kind()) == std::string_view::npos) {
            throw py::value_error(std::string(name) + " must be integers");
        }
        const py::int_ low(any.attr("min")());
        const py::int_ high(any.attr("max")());
        if (low < py::int_(std::numeric_limits<T>::min()) || high > py::int_(std::numeric_limits<T>::max())) {
            throw py::value_error(std::string(name) + " contains numbers that are too large");
        }
    }
    return Array<T>::ensure(any);
}

/// Throws unless there is one row per point.
inline void checkRows(std::size_t rows, std::size_t points, const char* name)
{
    if (rows != points) {
        throw py::value_error(std::string(name) + " has " + std::to_string(rows) + " rows, but there are " +
                              std::to_string(points) + " points");
    }
}

/// Throws unless there is one row per point, or no rows at all.
inline void checkOptionalRows(std::size_t rows, std::size_t points, const char* name)
{
    if (rows != 0) {
        checkRows(rows, points, name);
    }
}

/// Converts a one-dimensional array to a vector.
template <class T>
std::vector<T> valuesOf(const Array<T>& array, const char* name)
{
    checkShape(array.ndim() == 1, name, "(N,)");
    return {array.data(), array.data() + array.size()};
}

/// Converts a one-dimensional array to a vector, or None to an empty vector.
template <class T>
std::vector<T> valuesOf(const std::optional<Array<T>>& array, const char* name)
{
    return array ? valuesOf(*array, name) : std::vector<T>();
}

inline std::vector<int> idsOf(const py::object& ids, const char* name)
{
    return ids.is_none() ? std::vector<int>() : valuesOf(toIntegerArray<int>(ids, name), name);
}

inline Image imageOf(const Array<float>& rows, const char* name)
{
    checkShape(rows.ndim() == 2, name, "(height, width)");
    return {static_cast<int>(rows.shape(1)), static_cast<int>(rows.shape(0)), {rows.data(), rows.data() + rows.size()}};
}

/// A T that is part of another object: its attributes are read-only, but copies are writable.
template <class T>
struct ReadOnly : T {
    explicit ReadOnly(T value) : T(std::move(value)) {}
};

[[noreturn]] inline void throwReadOnlyError(const std::string& name)
{
    throw py::attribute_error(
        "setting '" + name +
        "' on a value returned by another object would be lost: change a copy.copy() of it and assign that");
}

template <class T>
auto bindReadOnly(py::module_& module, const char* name)
{
    return py::class_<ReadOnly<T>, T>(module, name)
        .def("__setattr__", [](const ReadOnly<T>&, const std::string& attribute, const py::object&) {
            throwReadOnlyError(attribute);
        });
}

/// Converts a matrix to a read-only NumPy array.
template <class Matrix>
py::array readOnlyArray(const Matrix& matrix)
{
    py::array array = py::cast(matrix);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// Converts a matrix to a read-only NumPy array, or an empty optional to None.
template <class Matrix>
py::object readOnlyArray(const std::optional<Matrix>& matrix)
{
    return matrix ? py::object(readOnlyArray(*matrix)) : py::object(py::none());
}

template <class T>
py::tuple readOnlyTuple(const std::vector<T>& values)
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

/// Getter for def_property that returns a list field as a tuple.
template <auto Field>
auto asTuple()
{
    return [](const typename MemberOf<decltype(Field)>::Owner& owner) { return readOnlyTuple(owner.*Field); };
}

/// Getter for def_property that returns a matrix or optional matrix field as a read-only array.
template <auto Field>
auto asArray()
{
    return [](const typename MemberOf<decltype(Field)>::Owner& owner) { return readOnlyArray(owner.*Field); };
}

/// Setter for def_property that goes with the getters above.
template <auto Field>
auto assign()
{
    using Member = MemberOf<decltype(Field)>;
    return [](typename Member::Owner& owner, const typename Member::Value& value) { owner.*Field = value; };
}

}   // namespace angiopose::python
