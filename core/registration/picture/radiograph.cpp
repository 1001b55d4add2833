#include "core/registration/picture/radiograph.h"

#include "core/imaging/volume.h"
#include "core/registration/picture/tube_picture.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double wideningShare = 1.5;   // of the radius: the mask reaches a little beyond the vessel
constexpr double unknownTubeRadiusMm = 1.5;
constexpr double tissueHu = 150.0;   // what is denser holds contrast medium

/// Adds to the four pixels around a place, by how near they are.
void splat(ImageF& image, const Eigen::Vector2d& place, float value)
{
    const double x = std::floor(place.x());
    const double y = std::floor(place.y());
    if (!(x >= 0.0 && y >= 0.0 && x + 1.0 < image.width && y + 1.0 < image.height)) {
        return;
    }
    const auto fx = static_cast<float>(place.x() - x);
    const auto fy = static_cast<float>(place.y() - y);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    image.at(left, top) += (1.0F - fx) * (1.0F - fy) * value;
    image.at(left + 1, top) += fx * (1.0F - fy) * value;
    image.at(left, top + 1) += (1.0F - fx) * fy * value;
    image.at(left + 1, top + 1) += fx * fy * value;
}

/// Marks the voxels within `radiusMm` of a point.
void markBall(const Eigen::Vector3d& pointInPatient, double radiusMm, VoxelMask& mask)
{
    const VolumeGeometry& geometry = mask.geometry;
    const Eigen::Affine3d voxelFromPatient = geometry.patientFromVoxel().inverse();
    const Eigen::Vector3d centre = voxelFromPatient * pointInPatient;
    const Eigen::Vector3d reach = geometry.spacingMm.cwiseInverse() * radiusMm;
    const Eigen::Vector3i low = (centre - reach).array().ceil().cast<int>().max(0);
    const Eigen::Vector3i high = (centre + reach).array().floor().cast<int>().min(geometry.size.array() - 1);
    for (int k = low.z(); k <= high.z(); ++k) {
        for (int j = low.y(); j <= high.y(); ++j) {
            for (int i = low.x(); i <= high.x(); ++i) {
                const Eigen::Vector3d offsetMm = geometry.spacingMm.cwiseProduct(Eigen::Vector3d(i, j, k) - centre);
                if (offsetMm.squaredNorm() <= radiusMm * radiusMm) {
                    mask.at(i, j, k) = 1;
                }
            }
        }
    }
}

}   // namespace

Radiograph::Radiograph(const RegistrationProblem& problem) : tree_(problem.tree), camera_(halved(problem.camera))
{
    if (problem.volume) {
        collectVoxels(*problem.volume);
    }
}

void Radiograph::collectVoxels(const Volume& volume)
{
    VoxelMask mask(volume.geometry);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
        const double radiusMm = tree_.radiusMm[i] > 0.0 ? tree_.radiusMm[i] : unknownTubeRadiusMm;
        markBall(tree_.points[i], wideningShare * radiusMm, mask);
    }
    spacingMm_ = volume.geometry.spacingMm.maxCoeff();
    const Eigen::Affine3d patientFromVoxel = volume.geometry.patientFromVoxel();
    const Eigen::Vector3i& size = volume.geometry.size;
    for (int k = 0; k < size.z(); ++k) {
        for (int j = 0; j < size.y(); ++j) {
            for (int i = 0; i < size.x(); ++i) {
                const std::size_t index = volume.geometry.index(i, j, k);
                const double contrast = mask.voxels[index] != 0 ? volume.value(index) - tissueHu : 0.0;
                if (contrast > 0.0) {
                    voxels_.push_back({patientFromVoxel * Eigen::Vector3d(i, j, k), static_cast<float>(contrast)});
                }
            }
        }
    }
}

ImageF Radiograph::from(const RigidTransform& cameraFromPatient) const
{
    return voxels_.empty() ? pictureOf(tree_, camera_, cameraFromPatient) : ofVoxels(cameraFromPatient);
}

/// Every voxel adds its contrast where it projects, spread over the pixels it covers.
ImageF Radiograph::ofVoxels(const RigidTransform& cameraFromPatient) const
{
    ImageF image(camera_.width, camera_.height);
    for (const Voxel& voxel : voxels_) {
        const Eigen::Vector3d point = cameraFromPatient * voxel.place;
        const auto pixel = project(camera_, point);
        if (!pixel) {
            continue;
        }
        const double sizePx = spacingMm_ / millimetresPerPixel(camera_, point.z());
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

}   // namespace angiopose::core