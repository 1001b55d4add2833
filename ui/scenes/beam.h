#pragma once

#include "core/geometry/projection_camera.h"
#include "core/geometry/rigid_transform.h"
#include "ui/scenes/orbit.h"
#include "ui/scenes/stroke_mesh.h"

#include <array>

namespace angiopose::ui {

/// X-ray source and detector in patient space.
struct Beam {
    core::ProjectionCamera camera;
    double sourceToDetectorMm = 0.0;
    core::RigidTransform patientFromCamera;

    bool hasDetector() const { return sourceToDetectorMm > 0.0 && !core::findProblem(camera); }
    Eigen::Vector3d source() const { return patientFromCamera.translation; }

    /// Returns the matrix that maps (u, v, 0), image px, to the point on the detector, patient mm.
    Eigen::Matrix4d patientFromImagePlane() const;

    /// Returns the image corners on the detector in patient space, mm, in order around the image border.
    std::array<Eigen::Vector3d, 4> detectorCorners() const;
};

struct BeamStyle {
    Palette colors;
    Eigen::Vector2d sizePx = Eigen::Vector2d::Zero();   ///< size of the view, device px
    double pixelScale = 1.0;
};

/// Adds the source dot, dashed beam edges and the detector border, clipped to the view.
void addBeamStrokes(StrokeMesh& mesh, const Beam& beam, const ScreenFromPatient& toScreen, const BeamStyle& style);

}   // namespace angiopose::ui
