#pragma once

#include "core/geometry/sight.h"
#include "core/support/result.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// A pose, and its camera where the file has one; 0 columns and rows where its image size is not said.
struct PoseWithCamera {
    core::RigidTransform cameraFromPatient;
    std::optional<core::ProjectionCamera> camera;
    std::string vesselSha256{};   ///< of what a result was found with; empty: not said
    std::string imageSha256{};
};

/// All that `readPose` reads, with its camera: the key `camera` beside a pose, P, or K, R and t in JSON, YAML and XML
/// as OpenCV writes them, twelve numbers as text (P), sixteen (a pose alone).
core::Result<PoseWithCamera> readPoseWithCamera(const std::string& path);

/// What may differ between two writings of one camera: relative.
inline constexpr double sameCameraTolerance = 1e-6;

/// Whether both project alike; a size that is not said fits any.
bool isSameCamera(const core::ProjectionCamera& a, const core::ProjectionCamera& b);

/// Whether both are of images of one size, or one does not say.
bool fitsImage(const core::ProjectionCamera& camera, int width, int height);

/// Writes K, R and t (`.json`, `.yml`, `.yaml`, `.xml`) or P (`.txt`), by extension.
core::Status writeSight(const core::Sight& sight, const std::string& path);

}   // namespace angiopose::io
