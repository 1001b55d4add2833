#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>

/// Conversions for reading and writing JSON: points as lists of numbers, missing values as null.
template <int Size>
struct nlohmann::adl_serializer<Eigen::Matrix<double, Size, 1>> {
    template <class Json>
    static void to_json(Json& json, const Eigen::Matrix<double, Size, 1>& point)
    {
        json = Json::array();
        for (const double coordinate : point) {
            json.push_back(coordinate);
        }
    }
    template <class Json>
    static void from_json(const Json& json, Eigen::Matrix<double, Size, 1>& point)
    {
        for (int axis = 0; axis < Size; ++axis) {
            point[axis] = json.at(static_cast<std::size_t>(axis)).template get<double>();
        }
    }
};

template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
    template <class Json>
    static void to_json(Json& json, const std::optional<Value>& value)
    {
        json = value ? Json(*value) : Json();
    }
    template <class Json>
    static void from_json(const Json& json, std::optional<Value>& value)
    {
        value = json.template get<Value>();
    }
};
