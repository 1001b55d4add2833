#include "io/pose_file.h"

#include "io/decode/itk_transform_file.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/objects/spatial_registration.h"
#include "io/messages/says.h"
#include "io/pose/itk_transform.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <exception>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

core::Result<core::RigidTransform> poseFromJson(std::string_view text, const std::string& path)
{
    if (const auto valid = checkJson(text, path); !valid) {
        return valid.error();
    }
    try {
        const Json root = Json::parse(text);
        const Json& holder = root.contains("pose") ? root.at("pose") : root;
        const auto pose = poseFromRows(holder.at("cameraFromPatient").get<MatrixRows>());
        return pose ? pose : fileError(path, pose.error());
    } catch (const Json::exception&) {
        return fileError(path, says::poseNoMatrix());
    }
}

std::string jsonText(const core::RigidTransform& cameraFromPatient)
{
    Json root;
    root["format"] = "angiopose-pose";
    root["version"] = 1;
    root["cameraFromPatient"] = rowsOf(cameraFromPatient);
    return prettyJson(root.dump());
}

}   // namespace

core::Result<core::RigidTransform> readPose(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (content.size() > (16U << 20)) {
        return fileError(path, says::poseTooLarge());
    }
    if (looksLikeDicom(content)) {
        return readSpatialRegistration(content, path);
    }
    const std::string extension = extensionOf(path);
    if (content.starts_with("#Insight Transform File") || extension == ".tfm" || extension == ".txt") {
        const auto pose = poseFromItkText(content);
        return pose ? pose : fileError(path, pose.error());
    }
    if (extension == ".mat") {
        const auto pose = poseFromItkMatlab(content);
        return pose ? pose : fileError(path, pose.error());
    }
    if (describeContent(content) == &says::anHdf5File) {
        return poseFromItkHdf5(path);
    }
    if (describeContent(content) == &says::aJsonFile || extension == ".json") {
        return poseFromJson(content, path);
    }
    return fileError(path, says::poseUnknown());
}

core::Status writePose(const core::RigidTransform& cameraFromPatient, const std::string& path)
{
    if (!core::isRigid(cameraFromPatient)) {
        return fileError(path, says::poseNotSaved());
    }
    const std::string extension = extensionOf(path);
    if (extension == ".tfm") {
        return writeAtomically(path, itkText(cameraFromPatient));
    }
    if (extension == ".h5") {
        return writeItkHdf5(cameraFromPatient, path);
    }
    if (extension == ".json") {
        return writeAtomically(path, jsonText(cameraFromPatient));
    }
    return fileError(path, says::poseExtension());
}

}   // namespace angiopose::io