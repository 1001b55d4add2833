#include "core/registration/picture/drr.h"

#include "core/imaging/mark_ball.h"
#include "core/imaging/reduce_volume.h"
#include "core/imaging/volume.h"
#include "core/registration/picture/tube_image.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double wideningShare = 1.5;   // radius of the mask in vessel radii; extends slightly beyond the vessel
constexpr double unknownTubeRadiusMm = 1.5;
constexpr std::size_t maxBodyVoxels = 700'000;
constexpr double airHu = -1000.0;
constexpr double minAirHu = -500.0;   // values below this show that a scan contains air and is in HU
constexpr double minDenseHu = 300.0;   // above air; excludes the lung, which would add many voxels
constexpr double tissueHu = 150.0;   // soft tissue without contrast agent; voxels with contrast agent are denser

/// Adds a value to the four pixels around a position with bilinear weights.
void splat(ImageF& image, const Eigen::Vector2d& position, float value)
{
    const double x = std::floor(position.x());
    const double y = std::floor(position.y());
    if (!(x >= 0.0 && y >= 0.0 && x + 1.0 < image.width && y + 1.0 < image.height)) {
        return;
    }
    const auto fx = static_cast<float>(position.x() - x);
    const auto fy = static_cast<float>(position.y() - y);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    image.at(left, top) += (1.0F - fx) * (1.0F - fy) * value;
    image.at(left + 1, top) += fx * (1.0F - fy) * value;
    image.at(left, top + 1) += (1.0F - fx) * fy * value;
    image.at(left + 1, top + 1) += fx * fy * value;
}

}   // namespace

Drr::Drr(const RegistrationProblem& problem) : tree_(problem.tree), camera_(halfSizeCamera(problem.camera))
{
    if (problem.volume) {
        collectVoxels(*problem.volume);
    }
}

void Drr::collectVoxels(const Volume& volume)
{
    VoxelMask mask(volume.geometry);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
        const double radiusMm = tree_.radiusMm[i] > 0.0 ? tree_.radiusMm[i] : unknownTubeRadiusMm;
        markBall(tree_.points[i], wideningShare * radiusMm, mask);
    }
    vessels_.spacingMm = volume.geometry.spacingMm.maxCoeff();
    const Eigen::Affine3d patientFromVoxel = volume.geometry.patientFromVoxel();
    const Eigen::Vector3i& size = volume.geometry.size;
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            for (int i = 0; i < size.x(); ++i) {
                const std::size_t index = volume.geometry.index(i, j, k);
                const double contrast = mask.voxels[index] != 0 ? volume.value(index) - tissueHu : 0.0;
                if (contrast > 0.0) {
                    vessels_.voxels.push_back(
                        {patientFromVoxel * Eigen::Vector3d(i, j, k), static_cast<float>(contrast)});
                }
            }
        }
    }
}

ImageF Drr::from(const RigidTransform& cameraFromPatient) const
{
    return vessels_.voxels.empty() ? renderTubes(tree_, camera_, cameraFromPatient)
                                   : vessels_.from(camera_, cameraFromPatient);
}

ImageF ProjectedVoxels::from(const ProjectionCamera& camera, const RigidTransform& cameraFromPatient) const
{
    ImageF image(camera.width, camera.height);
    for (const Voxel& voxel : voxels) {
        const Eigen::Vector3d point = cameraFromPatient * voxel.position;
        const auto pixel = project(camera, point);
        if (!pixel) {
            continue;
        }
        const double sizePx = spacingMm / millimetersPerPixel(camera, point.z());
        const int parts = std::clamp(static_cast<int>(std::ceil(sizePx)), 1, 8);
        const auto share = voxel.brightness / static_cast<float>(parts * parts);
        for (int part = 0; part < parts * parts; ++part) {
            const int row = part / parts;
            const int column = part % parts;
            const Eigen::Vector2d offset((column + 0.5) / parts - 0.5, (row + 0.5) / parts - 0.5);
            splat(image, *pixel + sizePx * offset, share);
        }
    }
    return image;
}

BodyDrr::BodyDrr(const Volume& scan, const ProjectionCamera& camera, int maxSidePx) : camera_(camera)
{
    while (std::max(camera_.width, camera_.height) > maxSidePx) {
        camera_ = halfSizeCamera(camera_);
    }
    const auto body = downsample(scan, voxelRangeIn(scan.geometry, {}), maxBodyVoxels, [] { return true; });
    if (!body) {
        return;
    }
    const auto [darkest, brightest] = std::ranges::minmax(body->voxels);
    const double low = body->slope * darkest + body->intercept;
    const double air = low < minAirHu ? airHu : low;
    body_.spacingMm = body->geometry.spacingMm.maxCoeff();
    const Eigen::Affine3d patientFromVoxel = body->geometry.patientFromVoxel();
    for (std::size_t i = 0; i < body->voxels.size(); ++i) {
        const double dense = body->value(i) - air;
        if (dense > minDenseHu) {
            const Eigen::Vector3d voxel = body->geometry.voxelAt(i).cast<double>();
            body_.voxels.push_back({patientFromVoxel * voxel, static_cast<float>(dense)});
        }
    }
}

}   // namespace angiopose::core
