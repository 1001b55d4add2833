#include "io/support/itk_transform_text.h"

#include "io/support/file_error.h"
#include "io/support/numbers.h"
#include "io/support/rigid_rows.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace io {
namespace {

struct ItkTransform {
    std::string type;
    std::vector<double> parameters;
    std::vector<double> fixedParameters;
};

std::optional<std::vector<double>> numbersOf(std::string_view text)
{
    std::istringstream words{std::string(text)};
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
        const auto number = parseNumber(word);
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<ItkTransform> parse(std::string_view text)
{
    std::istringstream lines{std::string(text)};
    ItkTransform transform;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        if (line.starts_with('#') || colon == std::string::npos) {
            continue;
        }
        const std::string_view label = trimmed(std::string_view(line).substr(0, colon));
        const std::string_view value = trimmed(std::string_view(line).substr(colon + 1));
        if (label == "Transform") {
            if (!transform.type.empty()) {
                return std::nullopt;   // several transforms: which one would be a guess
            }
            transform.type = value;
        } else if (label == "Parameters" || label == "FixedParameters") {
            const auto numbers = numbersOf(value);
            if (!numbers) {
                return std::nullopt;
            }
            (label == "Parameters" ? transform.parameters : transform.fixedParameters) = *numbers;
        }
    }
    return transform.type.empty() ? std::nullopt : std::optional(transform);
}

/// Linear part and offset before the centre is taken into account.
std::optional<Eigen::Matrix<double, 3, 4>> linearPart(const ItkTransform& transform)
{
    const auto& p = transform.parameters;
    Eigen::Matrix<double, 3, 4> result;
    const bool isMatrix = transform.type.starts_with("AffineTransform") || transform.type.starts_with("MatrixOffset") ||
                          transform.type.starts_with("Rigid3DTransform");
    if (isMatrix && p.size() == 12) {
        result << p[0], p[1], p[2], p[9], p[3], p[4], p[5], p[10], p[6], p[7], p[8], p[11];
        return result;
    }
    if (p.size() != 6) {
        return std::nullopt;
    }
    if (transform.type.starts_with("Euler3DTransform")) {   // R = Rz Rx Ry
        result.leftCols<3>() =
            (Eigen::AngleAxisd(p[2], Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(p[0], Eigen::Vector3d::UnitX()) *
             Eigen::AngleAxisd(p[1], Eigen::Vector3d::UnitY()))
                .toRotationMatrix();
    } else if (transform.type.starts_with("VersorRigid3DTransform")) {
        const Eigen::Vector3d vector(p[0], p[1], p[2]);
        const double scalar = std::sqrt(std::max(0.0, 1.0 - vector.squaredNorm()));
        result.leftCols<3>() =
            Eigen::Quaterniond(scalar, vector.x(), vector.y(), vector.z()).normalized().toRotationMatrix();
    } else {
        return std::nullopt;
    }
    result.col(3) = Eigen::Vector3d(p[3], p[4], p[5]);
    return result;
}

}   // namespace

core::Result<core::RigidTransform> poseOfItkText(std::string_view text, const std::string& path)
{
    const auto transform = parse(text);
    const auto linear = transform ? linearPart(*transform) : std::nullopt;
    if (!linear) {
        return fileError(path,
                         "this is not an ITK text transform with one 3-D rigid or affine transform. Give a .tfm "
                         "written by ITK, Slicer or this program.");
    }
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    if (transform->fixedParameters.size() >= 3) {
        centre = Eigen::Map<const Eigen::Vector3d>(transform->fixedParameters.data());
    }
    const Eigen::Vector3d translation = linear->col(3) + centre - linear->leftCols<3>() * centre;
    MatrixRows rows(4, {0.0, 0.0, 0.0, 1.0});
    for (int row = 0; row < 3; ++row) {
        rows[static_cast<std::size_t>(row)] = {(*linear)(row, 0), (*linear)(row, 1), (*linear)(row, 2),
                                               translation(row)};
    }
    return rigidFromRows(rows, path);
}

std::string itkTextOf(const core::RigidTransform& cameraFromPatient)
{
    std::string parameters;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            parameters += " " + toText(cameraFromPatient.rotation(row, column));
        }
    }
    for (int row = 0; row < 3; ++row) {
        parameters += " " + toText(cameraFromPatient.translation(row));
    }
    return "#Insight Transform File V1.0\n"
           "# AngioPose: maps patient points (LPS, mm) to camera points (mm). Not for clinical use.\n"
           "#Transform 0\n"
           "Transform: AffineTransform_double_3_3\n"
           "Parameters:" +
           parameters + "\nFixedParameters: 0 0 0\n";
}

}   // namespace io
