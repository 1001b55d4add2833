#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "io/dicom/objects/derived_object.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// The position of a C-arm relative to a scan.
struct CArmRegistration {
    core::RigidTransform cameraFromPatient;
    core::ProjectionCamera camera;
    std::string scanFrameOfReferenceUid;   ///< frame of reference UID of the patient coordinates of the vessels
    std::string cameraFrameOfReferenceUid;   ///< frame of reference UID of the camera; see cameraFrameOfReference
    std::string method;   ///< description of the registration method; may be empty
};

/// Returns the frame of reference UID of an image's camera, shared by all registrations to this image. The UID is
/// derived, because older X-ray images have no frame of reference.
std::string cameraFrameOfReference(const SourceImage& angiogram, const ObjectOrigin& origin);

/// Returns a Spatial Registration (PS3.3 A.39.1) in the frame of reference of the camera. The item for the scan's frame
/// of reference contains `cameraFromPatient`, which maps patient points of the scan to camera points (PS3.3 C.20.2:
/// "from the Referenced to the Registered RCS"); the item for the image contains the identity. Private elements hold
/// the camera (FORMATS §3.6). Fails if the pose is not rigid.
core::Result<std::string> encodeSpatialRegistration(const CArmRegistration& registration, const SourceImage& angiogram,
                                                    const ObjectOrigin& origin);

/// Reads the rigid transform of a spatial registration from another frame of reference to that of the object, with the
/// precision of 16 characters per number. Fails unless there is exactly one such transform.
core::Result<core::RigidTransform> readSpatialRegistration(std::string_view content, const std::string& path);

}   // namespace angiopose::io
