#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "io/dicom/objects/derived_object.h"

#include <optional>
#include <string>

namespace angiopose::io {

/// Where a C-arm stands to a scan.
struct CArmRegistration {
    core::RigidTransform cameraFromPatient;
    core::ProjectionCamera camera;
    std::string scanFrameOfReferenceUid;   ///< of the patient coordinates of the vessels
    std::string cameraFrameOfReferenceUid;   ///< of the camera coordinates, see cameraFrameOfReference
    std::string method;   ///< what found it, in words; may be empty
};

/// The frame of reference of the camera of an image: all registrations to one image share it. X-ray images of old have
/// none of their own.
std::string cameraFrameOfReference(const SourceImage& angiogram, const ObjectOrigin& origin);

/// Spatial Registration (PS3.3 A.39.1). Its own frame of reference is the camera's. The item of the scan's frame holds
/// `cameraFromPatient`: it takes patient points of the scan to camera points (PS3.3 C.20.2: "from the Referenced to the
/// Registered RCS"); the item of the image holds the identity. The camera stands in private elements (FORMATS §3.6).
/// Fails where the pose is not rigid.
core::Result<std::string> spatialRegistration(const CArmRegistration& registration, const SourceImage& angiogram,
                                              const ObjectOrigin& origin);

/// The rigid motion that a spatial registration holds, from another frame of reference to its own, as exact as its text
/// of 16 characters a number. Fails where it holds none, or not one alone.
core::Result<core::RigidTransform> readSpatialRegistration(std::string_view content, const std::string& path);

}   // namespace angiopose::io
