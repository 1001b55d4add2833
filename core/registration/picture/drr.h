#pragma once

#include "core/imaging/image2d.h"
#include "core/imaging/volume.h"
#include "core/registration/problem/registration_problem.h"

#include <vector>

namespace angiopose::core {

/// Set of voxels for projecting one by one.
struct XrayedVoxels {
    struct Voxel {
        Eigen::Vector3d place;   ///< patient LPS mm
        float brightness = 0.0F;
    };
    std::vector<Voxel> voxels;
    double spacingMm = 0.0;   ///< longest side of a voxel

    /// Adds the brightness of every voxel at its projection, spread over the pixels it covers.
    ImageF from(const ProjectionCamera& camera, const RigidTransform& cameraFromPatient) const;
};

/// Simulated radiographs of the whole body in a CT: line integrals of a reduced scan, dense tissue bright on 0. If the
/// values are not HU, uses the part above the darkest value.
class BodyDrr {
public:
    /// `longestSidePx` is the size of the radiographs, which cover the camera's field of view.
    BodyDrr(const Volume& scan, const ProjectionCamera& camera, int longestSidePx);

    ImageF from(const RigidTransform& cameraFromPatient) const { return body_.from(camera_, cameraFromPatient); }

private:
    ProjectionCamera camera_;
    XrayedVoxels body_;
};

/// Renders digitally reconstructed radiographs of the vessels at half the image's resolution: line integrals of the CTA
/// inside the dilated tree, or of tubes without a CTA (ALGORITHMS §3.7).
class Drr {
public:
    explicit Drr(const RegistrationProblem& problem);

    ImageF from(const RigidTransform& cameraFromPatient) const;

    const ProjectionCamera& camera() const { return camera_; }   ///< camera of the radiographs

private:
    void collectVoxels(const Volume& volume);

    const TreeSamples& tree_;
    ProjectionCamera camera_;
    XrayedVoxels vessels_;   ///< empty without a CTA
};

}   // namespace angiopose::core