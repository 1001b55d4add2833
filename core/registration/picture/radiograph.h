#pragma once

#include "core/imaging/image2d.h"
#include "core/registration/problem/registration_problem.h"

namespace angiopose::core {

/// Makes digitally reconstructed radiographs of the vessels at half the image's resolution: line integrals of the CTA
/// inside the widened tree, or of tubes where there is no CTA (ALGORITHMS §3.7).
class Radiograph {
public:
    explicit Radiograph(const RegistrationProblem& problem);

    ImageF from(const RigidTransform& cameraFromPatient) const;

    const ProjectionCamera& camera() const { return camera_; }   ///< of the radiographs

private:
    /// A voxel inside the vessels.
    struct Voxel {
        Eigen::Vector3d place;   ///< patient LPS mm
        float brightness = 0.0F;
    };
    void collectVoxels(const Volume& volume);
    ImageF ofVoxels(const RigidTransform& cameraFromPatient) const;

    const TreeSamples& tree_;
    ProjectionCamera camera_;
    double spacingMm_ = 0.0;   ///< widest side of a voxel
    std::vector<Voxel> voxels_;   ///< empty without a CTA
};

}   // namespace angiopose::core