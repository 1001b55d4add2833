// Arrays in, pose out: two vessels and their image points, registered from a start pose that is off.
#include <angiopose/angiopose.h>

#include <cmath>
#include <iostream>

int main()
{
    angiopose::RegistrationInput input;
    for (int i = 0; i < 160; ++i) {   // a vessel of 80 mm and a branch of 60 mm; patient LPS, mm
        const double t = i < 90 ? i / 89.0 : (i - 90) / 69.0;
        const Eigen::Vector3d trunk(30 * t, 20 * std::sin(3 * t), 80 * t - 40);
        const Eigen::Vector3d branch(12 + 45 * t, 18 - 30 * t * t, -8 - 25 * t);
        input.tree.points.push_back(i < 90 ? trunk : branch);
        input.tree.branchIds.push_back(i < 90 ? 1 : 2);
        input.tree.radiusMm.push_back(i < 90 ? 2.0 - t : 1.2 - 0.5 * t);
    }
    angiopose::CArm cArm;   // as DICOM has it: mm and degrees
    cArm.sourceToDetectorMm = 1100;
    cArm.sourceToPatientMm = 765;
    cArm.columnSpacingMm = cArm.rowSpacingMm = 0.3;
    cArm.primaryAngleDeg = -30;
    cArm.secondaryAngleDeg = 20;
    input.camera = angiopose::cameraFromCArm(cArm, 512, 512);

    const angiopose::Pose truth = angiopose::cameraFromPatient(cArm, {10, 0, 0});
    for (const Eigen::Vector3d& point : input.tree.points) {
        input.target.points.push_back(*angiopose::project(input.camera, truth, point));
    }
    input.target.curveIds = input.tree.branchIds;
    cArm.primaryAngleDeg = -26;   // the header is 4° off, the isocentre some mm
    input.initialCameraFromPatient = angiopose::cameraFromPatient(cArm, {4, 9, -6});

    const angiopose::RegistrationResult result = angiopose::registerVessels(input);
    const Eigen::Vector4d centre = result.uncertainty.centroidInPatient.homogeneous();   // far from it turns are shifts
    std::cout << result.cameraFromPatient << "\nmedian " << result.metrics.medianPx << " px, depth ± "
              << result.uncertainty.depthMm << " mm, off by " << ((result.cameraFromPatient - truth) * centre).norm()
              << " mm at the centroid\n";
    return result.metrics.medianPx < 0.5 ? 0 : 1;
}
