#include "tests/benchmark/asked_case.h"

#include <algorithm>

namespace angiopose::benchmarks {
namespace {

constexpr double maxMm = 1000.0;   // error of points that a wrong pose puts behind the source

double offMm(const RequestedCase& asked, const Eigen::Vector3d& found, const Eigen::Vector3d& there)
{
    const auto drawn = core::project(asked.input.camera, found);
    const auto shown = core::project(asked.trueCamera, there);
    if (!drawn || !shown) {
        return maxMm;
    }
    return std::min(maxMm, (*drawn - *shown).norm() * core::millimetersPerPixel(asked.trueCamera, there.z()));
}

}   // namespace

double overlayErrorMm(const RequestedCase& asked, const core::RigidTransform& cameraFromPatient)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t b = 0; b < asked.trueInCamera.size(); ++b) {
        for (std::size_t i = 0; i < asked.trueInCamera[b].size(); ++i) {
            const Eigen::Vector3d found = cameraFromPatient * asked.input.tree.branches[b].pointsInPatient[i];
            sum += offMm(asked, found, asked.trueInCamera[b][i]);
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : maxMm;
}

}   // namespace angiopose::benchmarks
