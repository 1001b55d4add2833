#pragma once

#include "core/geometry/sight.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A pose, and its camera if the file has one; 0 columns and rows if the file does not state the image size.
struct PoseWithCamera {
    core::RigidTransform cameraFromPatient;
    std::optional<core::ProjectionCamera> camera;
    std::string vesselSha256{};   ///< inputs that a result was computed from; empty: not stated
    std::string imageSha256{};
};

/// Reads everything that `readPose` reads, with its camera: the key `camera` next to a pose, P, or K, R and t in JSON,
/// YAML and XML as OpenCV writes them, twelve numbers as text (P), or sixteen (a pose alone).
core::Result<PoseWithCamera> readPoseWithCamera(const std::string& path);

/// Relative difference allowed between two representations of one camera.
inline constexpr double sameCameraTolerance = 1e-6;

/// Returns whether both cameras project alike; an unknown image size matches any.
bool isSameCamera(const core::ProjectionCamera& a, const core::ProjectionCamera& b);

/// Returns whether the camera fits an image of this size; an unknown image size fits any.
bool fitsImage(const core::ProjectionCamera& camera, int width, int height);

/// Writes K, R and t (`.json`, `.yml`, `.yaml`, `.xml`) or P (`.txt`), depending on the extension.
core::Status writeSight(const core::Sight& sight, const std::string& path);

}   // namespace angiopose::io
