#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "ui/scenes/orbit.h"
#include "ui/scenes/stroke_mesh.h"

#include <array>

namespace angiopose::ui {

/// The X-ray source and its detector in patient space.
struct Beam {
    core::ProjectionCamera camera;
    double sourceToDetectorMm = 0.0;
    core::RigidTransform patientFromCamera;

    bool hasDetector() const { return sourceToDetectorMm > 0.0 && !core::findProblem(camera); }
    Eigen::Vector3d source() const { return patientFromCamera.translation; }

    /// From (u, v, 0) in image px to the place on the detector, patient mm.
    Eigen::Matrix4d patientFromImagePlane() const;

    /// Corners of the image on the detector, in the order of the image border.
    std::array<Eigen::Vector3d, 4> detectorCorners() const;
};

struct BeamLook {
    Palette tones;
    Eigen::Vector2d sizePx = Eigen::Vector2d::Zero();   ///< of the picture
    double pixelScale = 1.0;
};

/// Source dot, dashed beam edges, border of the detector; of lines only what passes through the picture.
void addBeamStrokes(StrokeMesh& mesh, const Beam& beam, const ScreenFromPatient& toScreen, const BeamLook& look);

}   // namespace angiopose::ui