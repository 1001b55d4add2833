#include "io/pose_file.h"

#include "io/decode/itk_transform_file.h"
#include "io/messages/messages.h"
#include "io/pose/itk_transform.h"
#include "io/pose_camera_file.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

std::string jsonText(const core::RigidTransform& cameraFromPatient)
{
    nlohmann::ordered_json root;
    root["format"] = "angiopose-pose";
    root["version"] = 1;
    root["cameraFromPatient"] = rowsOf(cameraFromPatient);
    return prettyJson(root.dump());
}

}   // namespace

core::Result<core::RigidTransform> readPose(const std::string& path)
{
    const auto read = readPoseWithCamera(path);
    return read ? core::Result<core::RigidTransform>(read.value().cameraFromPatient) : read.error();
}

core::Status writePose(const core::RigidTransform& cameraFromPatient, const std::string& path)
{
    if (!core::isRigid(cameraFromPatient)) {
        return fileError(path, messages::poseNotSaved());
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
    return fileError(path, messages::poseExtension());
}

}   // namespace angiopose::io
