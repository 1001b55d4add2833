#include "io/volume/volume_headers.h"

#include "io/support/numbers.h"
#include "io/volume/volume_axes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace angiopose::io {
namespace {

constexpr int labelIntent = 1002;

void putText(std::string& header, std::size_t offset, std::string_view text)
{
    std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(offset));
}

template <class T>
void put(std::string& header, std::size_t offset, T value)
{
    std::memcpy(header.data() + offset, &value, sizeof value);
}

std::string vectorText(const Eigen::Vector3d& vector)
{
    return "(" + toText(vector.x()) + "," + toText(vector.y()) + "," + toText(vector.z()) + ")";
}

std::string listText(const Eigen::Vector3d& vector)
{
    return " " + toText(vector.x()) + " " + toText(vector.y()) + " " + toText(vector.z());
}

}   // namespace

std::string niftiHeader(const core::VolumeGeometry& geometry, double slope, double intercept, bool isLabel)
{
    std::string header(352, '\0');
    put<std::int32_t>(header, 0, 348);
    const std::array<int, 8> dim = {3, geometry.size.x(), geometry.size.y(), geometry.size.z(), 1, 1, 1, 1};
    const Eigen::Matrix3d axes = lpsFromRas(Eigen::Matrix3d(geometry.direction));   // the conversion is its own inverse
    const double handedness = axes.determinant() < 0.0 ? -1.0 : 1.0;
    const std::array<double, 4> pixdim = {handedness, geometry.spacingMm.x(), geometry.spacingMm.y(),
                                          geometry.spacingMm.z()};
    for (std::size_t i = 0; i < 8; ++i) {
        put(header, 40 + 2 * i, static_cast<std::int16_t>(dim[i]));
        put(header, 76 + 4 * i, static_cast<float>(i < 4 ? pixdim[i] : 0.0));
    }
    put<std::int16_t>(header, 68, static_cast<std::int16_t>(isLabel ? labelIntent : 0));
    put<std::int16_t>(header, 70, static_cast<std::int16_t>(isLabel ? 512 : 4));
    put<std::int16_t>(header, 72, 16);
    put(header, 108, 352.0F);
    put(header, 112, static_cast<float>(slope));
    put(header, 116, static_cast<float>(intercept));
    put<std::uint8_t>(header, 123, 2);   // units: mm
    put<std::int16_t>(header, 252, 1);
    put<std::int16_t>(header, 254, 1);
    Eigen::Matrix3d turn = axes;
    turn.col(2) *= handedness;
    Eigen::Quaterniond quaternion(turn);
    if (quaternion.w() < 0.0) {
        quaternion.coeffs() *= -1.0;
    }
    const Eigen::Vector3d origin = lpsFromRas(Eigen::Vector3d(geometry.originInPatient));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        put(header, 256 + 4 * i, static_cast<float>(quaternion.vec()[row]));
        put(header, 268 + 4 * i, static_cast<float>(origin[row]));
        for (std::size_t k = 0; k < 4; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            const double value = k < 3 ? axes(row, axis) * geometry.spacingMm[axis] : origin[row];
            put(header, 280 + 16 * i + 4 * k, static_cast<float>(value));
        }
    }
    putText(header, 344, std::string_view("n+1\0", 4));
    return header;
}

std::string nrrdHeader(const core::VolumeGeometry& geometry, std::string_view type)
{
    std::string header = "NRRD0004\ntype: " + std::string(type) + "\ndimension: 3\nspace: left-posterior-superior\n";
    header += "sizes: " + std::to_string(geometry.size.x()) + " " + std::to_string(geometry.size.y()) + " " +
              std::to_string(geometry.size.z()) + "\nspace directions:";
    for (int axis = 0; axis < 3; ++axis) {
        header += " " + vectorText(geometry.direction.col(axis) * geometry.spacingMm[axis]);
    }
    return header + "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: " +
           vectorText(geometry.originInPatient) + "\n\n";
}

std::string metaImageHeader(const core::VolumeGeometry& geometry, std::string_view type, std::size_t packedBytes)
{
    std::string header = "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n";
    header += "CompressedData = True\nCompressedDataSize = " + std::to_string(packedBytes) + "\nTransformMatrix =";
    for (int axis = 0; axis < 3; ++axis) {
        header += listText(geometry.direction.col(axis));
    }
    header += "\nOffset =" + listText(geometry.originInPatient) + "\nElementSpacing =" + listText(geometry.spacingMm);
    header += "\nDimSize = " + std::to_string(geometry.size.x()) + " " + std::to_string(geometry.size.y()) + " " +
              std::to_string(geometry.size.z());
    return header + "\nElementType = " + std::string(type) + "\nElementDataFile = LOCAL\n";
}

}   // namespace angiopose::io