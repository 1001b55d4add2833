#pragma once

#include "core/imaging/image2d.h"
#include "core/imaging/volume.h"
#include "core/registration/problem/registration_problem.h"

#include <vector>

namespace angiopose::core {

/// Voxels projected individually to render a DRR.
struct ProjectedVoxels {
    struct Voxel {
        Eigen::Vector3d position;   ///< position, patient LPS, mm
        float brightness = 0.0F;
    };
    std::vector<Voxel> voxels;
    double spacingMm = 0.0;   ///< largest voxel spacing

    /// Returns an image with the intensity of every voxel added at its projection, spread over the pixels it covers.
    ImageF from(const ProjectionCamera& camera, const RigidTransform& cameraFromPatient) const;
};

/// DRRs of the whole body in a CT: line integrals of a downsampled scan, with dense tissue bright on a background of 0.
/// For scans that are not in HU, the values above the lowest one are integrated.
class BodyDrr {
public:
    /// `maxSidePx` limits the size of the DRRs, which cover the camera's field of view.
    BodyDrr(const Volume& scan, const ProjectionCamera& camera, int maxSidePx);

    ImageF from(const RigidTransform& cameraFromPatient) const { return body_.from(camera_, cameraFromPatient); }

private:
    ProjectionCamera camera_;
    ProjectedVoxels body_;
};

/// Renders DRRs of the vessels at half the image resolution: line integrals of the CTA inside the dilated tree or,
/// without a CTA, of tubes (ALGORITHMS §3.7).
class Drr {
public:
    explicit Drr(const RegistrationProblem& problem);

    ImageF from(const RigidTransform& cameraFromPatient) const;

    const ProjectionCamera& camera() const { return camera_; }   ///< camera of the DRRs

private:
    void collectVoxels(const Volume& volume);

    const TreeSamples& tree_;
    ProjectionCamera camera_;
    ProjectedVoxels vessels_;   ///< empty if there is no CTA
};

}   // namespace angiopose::core
