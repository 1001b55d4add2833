#pragma once

#include "core/geometry/posed_camera.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A pose with its camera, if the file has one; columns and rows are 0 if the file does not state the image size.
struct PoseWithCamera {
    core::RigidTransform cameraFromPatient;
    std::optional<core::ProjectionCamera> camera;
    std::string vesselSha256{};   ///< SHA-256 of the inputs from which the result was computed; empty if not stated
    std::string imageSha256{};
};

/// Reads every format that `readPose` reads, with the camera: the key `camera` next to a pose; P, or K, R and t in
/// JSON, YAML and XML as OpenCV writes them; a text file with twelve numbers (P) or sixteen (pose without camera).
core::Result<PoseWithCamera> readPoseWithCamera(const std::string& path);

/// Maximum relative difference between two representations of the same camera.
inline constexpr double sameCameraTolerance = 1e-6;

/// Returns whether both cameras project every point to the same pixel; an unknown image size matches any.
bool isSameCamera(const core::ProjectionCamera& a, const core::ProjectionCamera& b);

/// Returns whether the camera is for an image of this size; an unknown image size matches any.
bool fitsImage(const core::ProjectionCamera& camera, int width, int height);

/// Writes K, R and t (`.json`, `.yml`, `.yaml`, `.xml`) or P (`.txt`), depending on the extension.
core::Status writePosedCamera(const core::PosedCamera& posedCamera, const std::string& path);

}   // namespace angiopose::io
