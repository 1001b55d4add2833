#include "io/pose_file.h"

#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/itk_transform_text.h"
#include "io/support/rigid_rows.h"

#include <nlohmann/json.hpp>

namespace io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* key = "cameraFromPatient";

/// The matrix wherever one of our files has it: at the top, in `pose`, or in a case's current or initial pose.
const Json* findMatrix(const Json& json)
{
    for (const char* pointer : {"", "/pose", "/pose/current", "/pose/initial"}) {
        const Json::json_pointer place(pointer);
        if (json.contains(place) && json.at(place).is_object() && json.at(place).contains(key)) {
            return &json.at(place).at(key);
        }
    }
    return nullptr;
}

core::Result<core::RigidTransform> poseOfJson(std::string_view text, const std::string& path)
{
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) {
        return fileError(path, "this is not valid JSON. Give a pose, a result or a case file.");
    }
    const Json* matrix = findMatrix(json);
    if (matrix == nullptr) {
        return fileError(path, "it has no cameraFromPatient. Give a pose, a result or a case file.");
    }
    try {
        return rigidFromRows(matrix->get<MatrixRows>(), path + ", cameraFromPatient");
    } catch (const Json::exception&) {
        return fileError(path, "cameraFromPatient is not a 4×4 matrix of numbers.");
    }
}

std::string jsonOf(const core::RigidTransform& pose)
{
    const Json json{{"format", "angiopose-pose"}, {"version", 1}, {key, rowsOf(pose)}};
    return json.dump(2) + "\n";
}

}   // namespace

core::Result<core::RigidTransform> readPose(const std::string& path)
{
    const auto bytes = openInput(path);
    if (!bytes) {
        return bytes.error();
    }
    const bool isItk = extensionOf(path) == ".tfm" || extensionOf(path) == ".txt";
    return isItk ? poseOfItkText(bytes.value().view(), path) : poseOfJson(bytes.value().view(), path);
}

core::Status writePose(const core::RigidTransform& cameraFromPatient, const std::string& path)
{
    return writeAtomically(path,
                           extensionOf(path) == ".tfm" ? itkTextOf(cameraFromPatient) : jsonOf(cameraFromPatient));
}

}   // namespace io
