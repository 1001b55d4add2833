#include "io/pose/named_matrices.h"

#include "core/exchange/projection_matrix.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using MatrixJson = nlohmann::json;
using Names = std::initializer_list<std::string_view>;

constexpr std::size_t maxValues = 4096;

const Names projectionNames{"P", "projection", "projection_matrix", "projectionMatrix"};
const Names intrinsicNames{"K", "camera_matrix", "cameraMatrix", "intrinsic", "intrinsic_matrix", "intrinsics", "M"};
const Names rotationNames{"R", "rotation", "rotation_matrix", "rvec"};
const Names translationNames{"t", "T", "tvec", "translation"};
const Names distortionNames{"distortion_coefficients", "dist_coeffs", "distCoeffs", "distortion", "D"};

/// Appends the numbers in nested arrays in order; returns false if the arrays contain anything else.
bool appendNumbers(const MatrixJson& json, std::vector<double>& values)
{
    if (json.is_number() && values.size() < maxValues) {
        values.push_back(json.get<double>());
        return true;
    }
    return json.is_array() &&
           std::ranges::all_of(json, [&values](const MatrixJson& part) { return appendNumbers(part, values); });
}

/// Returns the first matrix with one of the names and one of the sizes; null if there is none.
const std::vector<double>* find(const NamedMatrices& matrices, Names names, std::initializer_list<std::size_t> sizes)
{
    for (const std::string_view name : names) {
        const auto found = matrices.find(name);
        if (found != matrices.end() && std::ranges::find(sizes, found->second.size()) != sizes.end()) {
            return &found->second;
        }
    }
    return nullptr;
}

int pixelsOf(const NamedMatrices& matrices, Names names, std::size_t place)
{
    const auto* both = find(matrices, {"image_size", "imageSize", "size"}, {2});
    const auto* one = find(matrices, names, {1});
    const double pixels = both ? (*both)[place] : one ? one->front() : 0.0;
    return pixels >= 1.0 && pixels < 1e6 ? static_cast<int>(pixels) : 0;
}

using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Matrix3d rotationOf(const std::vector<double>& values)
{
    return values.size() == 3 ? core::expSo3(Eigen::Vector3d(values.data()))
                              : Eigen::Matrix3d(Eigen::Map<const RowMajor3>(values.data()));
}

}   // namespace

NamedMatrices parseJsonMatrices(std::string_view json)
{
    NamedMatrices matrices;
    const MatrixJson root = MatrixJson::parse(json, nullptr, false);
    if (!root.is_object()) {
        return matrices;
    }
    for (const auto& [name, value] : root.items()) {
        const MatrixJson& holder = value.is_object() && value.contains("data") ? value.at("data") : value;
        std::vector<double> numbers;
        if (appendNumbers(holder, numbers)) {
            matrices[name] = std::move(numbers);
        }
    }
    return matrices;
}

bool describesCamera(const NamedMatrices& matrices)
{
    const bool hasParts = find(matrices, intrinsicNames, {9}) && find(matrices, rotationNames, {3, 9}) &&
                          find(matrices, translationNames, {3});
    return hasParts || (!find(matrices, intrinsicNames, {9}) && find(matrices, projectionNames, {12}));
}

core::Result<core::PosedCamera> posedCameraFrom(const NamedMatrices& matrices)
{
    if (!describesCamera(matrices)) {
        return core::Error(messages::exchangeNoPose());
    }
    for (const std::string_view name : distortionNames) {
        const auto found = matrices.find(name);
        if (found != matrices.end() && std::ranges::any_of(found->second, [](double k) { return k != 0.0; })) {
            return core::Error(messages::exchangeDistorted());
        }
    }
    const auto* intrinsic = find(matrices, intrinsicNames, {9});
    using RowMajor34 = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
    auto posedCamera =
        intrinsic
            ? core::posedCameraFromIntrinsics(Eigen::Map<const RowMajor3>(intrinsic->data()),
                                              rotationOf(*find(matrices, rotationNames, {3, 9})),
                                              Eigen::Vector3d(find(matrices, translationNames, {3})->data()))
            : core::posedCameraFromMatrix(Eigen::Map<const RowMajor34>(find(matrices, projectionNames, {12})->data()));
    if (!posedCamera) {
        return posedCamera;
    }
    core::PosedCamera sized = std::move(posedCamera).value();
    sized.camera.width = pixelsOf(matrices, {"image_width", "imageWidth", "width"}, 0);
    sized.camera.height = pixelsOf(matrices, {"image_height", "imageHeight", "height"}, 1);
    return sized;
}

}   // namespace angiopose::io
