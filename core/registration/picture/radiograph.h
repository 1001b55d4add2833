#pragma once

#include "core/imaging/image2d.h"
#include "core/imaging/volume.h"
#include "core/registration/problem/registration_problem.h"

#include <vector>

namespace angiopose::core {

/// Voxels that X-rays pass, each for itself.
struct XrayedVoxels {
    struct Voxel {
        Eigen::Vector3d place;   ///< patient LPS mm
        float brightness = 0.0F;
    };
    std::vector<Voxel> voxels;
    double spacingMm = 0.0;   ///< widest side of a voxel

    /// Every voxel adds its brightness where it projects, spread over the pixels it covers.
    ImageF from(const ProjectionCamera& camera, const RigidTransform& cameraFromPatient) const;
};

/// What a CT shows to X-rays, all of the body: line integrals of a reduced scan, dense bright on 0. Of values that are
/// no HU, what lies above the darkest.
class BodyRadiograph {
public:
    /// `longestSidePx`: of the radiographs, which show what the camera sees.
    BodyRadiograph(const Volume& scan, const ProjectionCamera& camera, int longestSidePx);

    ImageF from(const RigidTransform& cameraFromPatient) const { return body_.from(camera_, cameraFromPatient); }

private:
    ProjectionCamera camera_;
    XrayedVoxels body_;
};

/// Makes digitally reconstructed radiographs of the vessels at half the image's resolution: line integrals of the CTA
/// inside the widened tree, or of tubes where there is no CTA (ALGORITHMS §3.7).
class Radiograph {
public:
    explicit Radiograph(const RegistrationProblem& problem);

    ImageF from(const RigidTransform& cameraFromPatient) const;

    const ProjectionCamera& camera() const { return camera_; }   ///< of the radiographs

private:
    void collectVoxels(const Volume& volume);

    const TreeSamples& tree_;
    ProjectionCamera camera_;
    XrayedVoxels vessels_;   ///< none without a CTA
};

}   // namespace angiopose::core