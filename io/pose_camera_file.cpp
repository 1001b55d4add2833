#include "io/pose_camera_file.h"

#include "io/decode/itk_transform_file.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/messages/messages.h"
#include "io/pose/itk_transform.h"
#include "io/pose/opencv_storage.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using PoseJson = nlohmann::ordered_json;

core::Result<PoseWithCamera> poseAlone(const core::Result<core::RigidTransform>& pose, const std::string& path)
{
    return pose ? core::Result<PoseWithCamera>(PoseWithCamera{pose.value(), std::nullopt})
                : fileError(path, pose.error());
}

core::Result<PoseWithCamera> withCamera(const core::Result<core::PosedCamera>& posedCamera, const std::string& path)
{
    return posedCamera ? core::Result<PoseWithCamera>(
                             PoseWithCamera{posedCamera.value().cameraFromPatient, posedCamera.value().camera})
                       : fileError(path, posedCamera.error());
}

/// Reads the camera of a case or pose file; a key of the same name in a result file has another meaning.
std::optional<core::ProjectionCamera> readCaseCamera(const PoseJson& root)
{
    const auto found = root.find("camera");
    if (found == root.end() || !found->is_object() || !found->contains("fx")) {
        return std::nullopt;
    }
    return core::ProjectionCamera{found->at("fx").get<double>(), found->at("fy").get<double>(),
                                  found->at("cx").get<double>(), found->at("cy").get<double>(),
                                  found->value("width", 0),      found->value("height", 0)};
}

std::optional<core::Message> findProblemApartFromSize(core::ProjectionCamera camera)
{
    camera.width = camera.height = 1;
    return core::findProblem(camera);
}

/// Returns the SHA-256 that a result states for an input; empty if not stated.
std::string hashOf(const PoseJson& root, const char* input)
{
    const auto inputs = root.find("inputs");
    return inputs != root.end() && inputs->is_object() && inputs->contains(input) && inputs->at(input).is_object()
               ? inputs->at(input).value("sha256", "")
               : std::string();
}

core::Result<PoseWithCamera> ofJson(std::string_view text, const std::string& path)
{
    if (const auto valid = checkJson(text, path); !valid) {
        return valid.error();
    }
    if (const NamedMatrices matrices = parseJsonMatrices(text); describesCamera(matrices)) {
        return withCamera(posedCameraFrom(matrices), path);
    }
    try {
        const PoseJson root = PoseJson::parse(text);
        const PoseJson& holder = root.contains("pose") ? root.at("pose") : root;
        const auto pose = poseFromRows(holder.at("cameraFromPatient").get<MatrixRows>());
        const auto camera = readCaseCamera(root);
        if (const auto problem = camera ? findProblemApartFromSize(*camera) : std::nullopt) {
            return fileError(path, *problem);
        }
        return pose ? core::Result<PoseWithCamera>(
                          PoseWithCamera{pose.value(), camera, hashOf(root, "vessel"), hashOf(root, "angiogram")})
                    : fileError(path, pose.error());
    } catch (const PoseJson::exception&) {
        return fileError(path, messages::poseNoMatrix());
    }
}

/// Interprets twelve numbers as P and sixteen as a 4 × 4 pose matrix.
core::Result<PoseWithCamera> poseFromNumbers(const std::vector<double>& numbers, const std::string& path)
{
    if (numbers.size() == 12) {
        return withCamera(posedCameraFrom({{"P", numbers}}), path);
    }
    if (numbers.size() != 16) {
        return fileError(path, messages::exchangeNumbers(numbers.size()));
    }
    MatrixRows rows;
    for (auto row = numbers.begin(); row != numbers.end(); row += 4) {
        rows.emplace_back(row, row + 4);
    }
    return poseAlone(poseFromRows(rows), path);
}

bool isXml(std::string_view content)
{
    return content.starts_with("<?xml") || content.starts_with("<opencv_storage>");
}

core::Result<PoseWithCamera> ofText(std::string_view content, const std::string& extension, const std::string& path)
{
    if (content.starts_with("%YAML") || extension == ".yml" || extension == ".yaml") {
        return withCamera(posedCameraFrom(parseYamlMatrices(content)), path);
    }
    if (isXml(content) || extension == ".xml") {
        return withCamera(posedCameraFrom(parseXmlMatrices(content)), path);
    }
    if (const auto numbers = parseNumbers(content); !numbers.empty()) {
        return poseFromNumbers(numbers, path);
    }
    return extension == ".tfm" || extension == ".txt" ? poseAlone(poseFromItkText(content), path)
                                                      : fileError(path, messages::poseUnknown());
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= sameCameraTolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

}   // namespace

core::Result<PoseWithCamera> readPoseWithCamera(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (content.size() > (16U << 20)) {
        return fileError(path, messages::poseTooLarge());
    }
    const std::string extension = extensionOf(path);
    if (extension == ".pt" || extension == ".pth") {
        return fileError(path, messages::exchangePickle());
    }
    if (looksLikeDicom(content)) {
        const auto pose = readSpatialRegistration(content, path);
        return pose ? core::Result<PoseWithCamera>(PoseWithCamera{pose.value(), std::nullopt}) : pose.error();
    }
    if (content.starts_with("#Insight Transform File") || extension == ".tfm") {
        return poseAlone(poseFromItkText(content), path);
    }
    if (extension == ".mat") {
        return poseAlone(poseFromItkMatlab(content), path);
    }
    if (describeContent(content) == &messages::anHdf5File) {
        const auto pose = poseFromItkHdf5(path);
        return pose ? core::Result<PoseWithCamera>(PoseWithCamera{pose.value(), std::nullopt}) : pose.error();
    }
    if (describeContent(content) == &messages::aJsonFile || extension == ".json") {
        return ofJson(content, path);
    }
    return ofText(content, extension, path);
}

bool isSameCamera(const core::ProjectionCamera& a, const core::ProjectionCamera& b)
{
    const bool fits = a.width == 0 || b.width == 0 || (a.width == b.width && a.height == b.height);
    return fits && isNear(a.fx, b.fx) && isNear(a.fy, b.fy) && isNear(a.cx, b.cx) && isNear(a.cy, b.cy);
}

bool fitsImage(const core::ProjectionCamera& camera, int width, int height)
{
    return camera.width == 0 || (camera.width == width && camera.height == height);
}

core::Status writePosedCamera(const core::PosedCamera& posedCamera, const std::string& path)
{
    if (!core::isRigid(posedCamera.cameraFromPatient)) {
        return fileError(path, messages::poseNotSaved());
    }
    const std::string extension = extensionOf(path);
    if (extension == ".txt") {
        return writeAtomically(path, projectionText(posedCamera));
    }
    if (extension == ".yml" || extension == ".yaml") {
        return writeAtomically(path, openCvYaml(posedCamera));
    }
    if (extension == ".xml") {
        return writeAtomically(path, openCvXml(posedCamera));
    }
    return extension == ".json" ? writeAtomically(path, openCvJson(posedCamera))
                                : fileError(path, messages::exchangeExtension());
}

}   // namespace angiopose::io
