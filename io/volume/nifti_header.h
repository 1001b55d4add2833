#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace angiopose::io {

enum class NiftiVersion { None, Analyze, One, Two };

/// The fields of either version that matter here.
struct NiftiHeader {
    NiftiVersion version = NiftiVersion::One;
    std::array<std::int64_t, 8> dim{};
    std::array<double, 8> pixdim{};
    int datatype = 0;
    double dataOffset = 0.0;
    double slope = 0.0;
    double intercept = 0.0;
    int intent = 0;
    int units = 0;
    int qformCode = 0;
    int sformCode = 0;
    Eigen::Vector3d quaternion;   ///< b, c, d
    Eigen::Vector3d quaternionOffset;
    Eigen::Matrix<double, 3, 4> sform;
    bool isPair = false;
    bool isSwapped = false;
};

/// Which kind of header these bytes are; `None` for other content.
NiftiVersion niftiVersionOf(std::string_view head);

/// The fields of a NIfTI-1 or NIfTI-2 header; nothing for Analyze and other content.
std::optional<NiftiHeader> niftiHeaderOf(std::string_view head);

}   // namespace angiopose::io