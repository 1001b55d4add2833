#include "io/pose/itk_transform.h"

#include "io/messages/messages.h"
#include "io/support/byte_order.h"
#include "io/support/numbers.h"
#include "io/support/pose_matrix.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <optional>
#include <vector>

namespace angiopose::io {
namespace {

/// Transform of an ITK file, as stored.
struct ItkTransform {
    int count = 0;
    std::string type;
    std::vector<double> parameters;
    std::vector<double> fixed;   ///< center of rotation; for Euler angles, followed by a flag for the order Z Y X
};

constexpr std::size_t maxParameters = 100;

std::optional<std::vector<double>> numbersIn(std::string_view text)
{
    std::vector<double> values;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::string_view word = text.substr(0, text.find_first_of(" \t"));
        const auto value = parseNumber(word);
        if (!value || values.size() > maxParameters) {
            return std::nullopt;
        }
        values.push_back(*value);
        text.remove_prefix(word.size());
    }
    return values;
}

std::optional<ItkTransform> parse(std::string_view text)
{
    ItkTransform transform;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view line = trimmed(text.substr(start, end - start));
        start = end + 1;
        const std::size_t colon = line.find(':');
        if (line.empty() || line.front() == '#' || colon == std::string_view::npos) {
            continue;
        }
        const std::string_view key = line.substr(0, colon);
        const std::string_view value = trimmed(line.substr(colon + 1));
        const auto numbers = key == "Transform" ? std::vector<double>() : numbersIn(value);
        if (!numbers) {
            return std::nullopt;
        }
        if (key == "Transform") {
            ++transform.count;
            transform.type = value;
        } else if (key == "Parameters") {
            transform.parameters = *numbers;
        } else if (key == "FixedParameters") {
            transform.fixed = *numbers;
        }
    }
    return transform;
}

Eigen::Vector3d vectorAt(const std::vector<double>& values, std::size_t first)
{
    return {values[first], values[first + 1], values[first + 2]};
}

/// Returns rotation and translation from ITK's parameters; nullopt if they are not rigid or their number is wrong.
std::optional<core::RigidTransform> motionOf(const ItkTransform& transform)
{
    const std::vector<double>& p = transform.parameters;
    const bool isMatrix =
        transform.type.starts_with("AffineTransform") || transform.type.starts_with("MatrixOffsetTransformBase");
    if (isMatrix && p.size() == 12) {
        Eigen::Matrix3d rotation;
        rotation << p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8];
        return core::RigidTransform{rotation, vectorAt(p, 9)};
    }
    if (transform.type.starts_with("VersorRigid3DTransform") && p.size() == 6) {
        const Eigen::Vector3d axis = vectorAt(p, 0);   // versor: axis times the sine of half the angle
        const double w = std::sqrt(std::max(0.0, 1.0 - axis.squaredNorm()));
        return core::RigidTransform{Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized().toRotationMatrix(),
                                    vectorAt(p, 3)};
    }
    if (transform.type.starts_with("Euler3DTransform") && p.size() == 6) {   // R = Rz Rx Ry, or Rz Ry Rx
        const Eigen::AngleAxisd x(p[0], Eigen::Vector3d::UnitX()), y(p[1], Eigen::Vector3d::UnitY());
        const Eigen::AngleAxisd z(p[2], Eigen::Vector3d::UnitZ());
        const bool isZyx = transform.fixed.size() > 3 && transform.fixed[3] != 0.0;
        return core::RigidTransform{(isZyx ? z * y * x : z * x * y).toRotationMatrix(), vectorAt(p, 3)};
    }
    return std::nullopt;
}

core::Result<core::RigidTransform> poseOf(const std::optional<ItkTransform>& transform)
{
    if (!transform || transform->count != 1) {
        return core::Error(messages::poseNoTransform());
    }
    const auto motion = motionOf(*transform);
    if (!motion) {
        return core::Error(messages::poseNotRigidTransform(transform->type.substr(0, 60)));
    }
    auto pose = poseFromRows(rowsOf(*motion));
    if (!pose || transform->fixed.size() < 3) {
        return pose;
    }
    core::RigidTransform shifted = std::move(pose).value();
    const Eigen::Vector3d center = vectorAt(transform->fixed, 0);
    if (!center.isZero(0.0)) {
        shifted.translation += center - shifted.rotation * center;
    }
    return shifted.translation.allFinite() ? core::Result<core::RigidTransform>(shifted)
                                           : core::Error(messages::poseCenterNotFinite());
}

/// Matrix read from a MATLAB Level 4 MAT-file.
struct MatlabMatrix {
    std::string name;
    std::vector<double> values;
};

template <class Number>
std::vector<double> numbersOf(std::string_view bytes)
{
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return {numbers.begin(), numbers.end()};
}

/// Consumes one matrix: header (type, rows, columns, imaginary flag, name length), name and values; nullopt if damaged.
std::optional<MatlabMatrix> takeMatrix(std::string_view& rest)
{
    constexpr std::size_t headSize = 20;
    constexpr std::uint32_t singlePrecision = 10, longestName = 200;   // type code of little-endian files
    if (rest.size() < headSize) {
        return std::nullopt;
    }
    const auto field = [&](std::size_t i) { return readUint32(rest.substr(4 * i), ByteOrder::Little); };
    const std::uint32_t type = field(0), rows = field(1), columns = field(2), nameSize = field(4);
    const bool isKnown = (type == 0 || type == singlePrecision) && field(3) == 0;
    if (!isKnown || rows > maxParameters || columns != 1 || nameSize == 0 || nameSize > longestName) {
        return std::nullopt;
    }
    const std::size_t valuesSize = std::size_t{rows} * (type == 0 ? sizeof(double) : sizeof(float));
    rest.remove_prefix(headSize);
    if (rest.size() < nameSize + valuesSize) {
        return std::nullopt;
    }
    const std::string_view values = rest.substr(nameSize, valuesSize);
    MatlabMatrix matrix{std::string(trimmed(rest.substr(0, nameSize))),
                        type == 0 ? numbersOf<double>(values) : numbersOf<float>(values)};
    rest.remove_prefix(nameSize + valuesSize);
    return matrix;
}

}   // namespace

core::Result<core::RigidTransform> poseFromItkText(std::string_view text)
{
    return poseOf(parse(text));
}

core::Result<core::RigidTransform> poseFromItkMatlab(std::string_view content)
{
    const auto parameters = takeMatrix(content);
    const auto fixed = takeMatrix(content);
    return parameters && fixed && fixed->name == "fixed" && content.empty()
               ? poseOf(ItkTransform{1, parameters->name, parameters->values, fixed->values})
               : core::Error(messages::poseNoTransform());
}

std::string itkText(const core::RigidTransform& cameraFromPatient)
{
    std::string text =
        "#Insight Transform File V1.0\n"
        "#Transform 0\n"
        "# cameraFromPatient: maps patient points (LPS, mm) to camera points (mm)\n"
        "Transform: AffineTransform_double_3_3\n"
        "Parameters:";
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            text += " " + toText(cameraFromPatient.rotation(i, k));
        }
    }
    for (int i = 0; i < 3; ++i) {
        text += " " + toText(cameraFromPatient.translation(i));
    }
    return text + "\nFixedParameters: 0 0 0\n";
}

}   // namespace angiopose::io
