#include "io/camera_pose_file.h"

#include "io/support/json_text.h"
#include "io/support/pose_matrix.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {

std::string cameraPoseText(const core::RigidTransform& cameraFromPatient, const core::ProjectionCamera& camera)
{
    nlohmann::ordered_json root;
    root["format"] = "angiopose-pose";
    root["version"] = 1;
    root["cameraFromPatient"] = rowsOf(cameraFromPatient);
    root["camera"] = {{"fx", camera.fx}, {"fy", camera.fy},       {"cx", camera.cx},
                      {"cy", camera.cy}, {"width", camera.width}, {"height", camera.height}};
    return prettyJson(root.dump());
}

}   // namespace angiopose::io
