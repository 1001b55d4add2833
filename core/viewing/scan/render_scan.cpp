#include "core/viewing/scan/render_scan.h"

#include "core/support/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr float opaqueThreshold = 0.98F;   // opacity above which everything behind is treated as invisible
constexpr float ambient = 0.30F;   // fraction of ambient light
constexpr float flatGradient = 1e-3F;

/// Lookup tables of opacity and color for every stored value and one ray step.
class TransferFunction {
public:
    TransferFunction(const PreparedVolume& scan, const ScanAppearance& appearance, double stepMm)
        : kinds_(appearance.kinds.empty() ? std::vector<Rgb>{appearance.softTissueColor} : appearance.kinds)
    {
        const auto [low, high] = std::ranges::minmax(scan.volume.voxels);
        low_ = low;
        const auto count = static_cast<std::size_t>(high - low) + 1;
        otherOpacity_.resize(count);
        vesselOpacity_.resize(count);
        boneFraction_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double value = scan.volume.slope * (static_cast<double>(i) + low) + scan.volume.intercept;
            otherOpacity_[i] = static_cast<float>(1.0 - std::exp(-stepMm * appearance.rest.at(value)));
            vesselOpacity_[i] = static_cast<float>(1.0 - std::exp(-stepMm * appearance.vessels.at(value)));
            const double valueRange = appearance.brightFrom - appearance.rest.from;
            boneFraction_[i] =
                static_cast<float>(std::clamp((value - appearance.rest.from) / std::max(valueRange, 1e-9), 0.0, 1.0));
        }
        soft_ = appearance.softTissueColor;
        bone_ = appearance.boneColor;
    }

    float opacity(float value, std::uint8_t kind) const
    {
        const auto at = static_cast<std::size_t>(value - low_ + 0.5F);
        return kind == 0 ? otherOpacity_[at] : vesselOpacity_[at];
    }
    Rgb color(float value, std::uint8_t kind) const
    {
        if (kind != 0) {
            return kinds_[std::min<std::size_t>(kind, kinds_.size()) - 1];
        }
        const float bright = boneFraction_[static_cast<std::size_t>(value - low_ + 0.5F)];
        Rgb mixed{};
        for (std::size_t c = 0; c < 3; ++c) {
            mixed[c] = soft_[c] + bright * (bone_[c] - soft_[c]);
        }
        return mixed;
    }
    /// Whether a block is visible: its maximum decides, as opacity increases with the value (its minimum for negative
    /// slopes).
    bool isVisible(const PreparedVolume::Block& block) const
    {
        const auto at = [this](std::int16_t value) { return static_cast<std::size_t>(value - low_); };
        const auto shows = [&](const std::vector<float>& opacity) {
            return opacity[at(block.low)] > 0.0F || opacity[at(block.high)] > 0.0F;
        };
        return (block.hasOtherVoxels && shows(otherOpacity_)) || (block.hasVessels && shows(vesselOpacity_));
    }

private:
    std::int16_t low_ = 0;
    std::vector<float> otherOpacity_, vesselOpacity_, boneFraction_;
    std::vector<Rgb> kinds_;
    Rgb soft_{};
    Rgb bone_{};
};

/// Interpolates the voxels around a position.
class VoxelInterpolator {
public:
    explicit VoxelInterpolator(const PreparedVolume& scan)
        : values_(scan.volume.voxels.data()),
          kinds_(scan.kinds.data()),
          last_(scan.volume.geometry.size.array() - 1),
          row_(scan.volume.geometry.size.x()),
          slice_(static_cast<std::ptrdiff_t>(scan.volume.geometry.size.x()) * scan.volume.geometry.size.y()),
          spacing_(scan.volume.geometry.spacingMm.cast<float>())
    {
    }

    float value(const Eigen::Array3f& at) const
    {
        const Eigen::Array3i low = at.cast<int>().min(last_ - 1).max(0);
        const Eigen::Array3f share = at - low.cast<float>();
        const std::int16_t* v = values_ + low.x() + low.y() * row_ + low.z() * slice_;
        const std::ptrdiff_t dx = last_.x() > 0 ? 1 : 0;
        const std::ptrdiff_t dy = last_.y() > 0 ? row_ : 0;
        const std::ptrdiff_t dz = last_.z() > 0 ? slice_ : 0;
        const auto along = [&](const std::int16_t* p) {
            return static_cast<float>(p[0]) + share.x() * static_cast<float>(p[dx] - p[0]);
        };
        const float near = along(v) + share.y() * (along(v + dy) - along(v));
        const float far = along(v + dz) + share.y() * (along(v + dz + dy) - along(v + dz));
        return near + share.z() * (far - near);
    }

    std::uint8_t kind(const Eigen::Array3f& at) const
    {
        const Eigen::Array3i nearest = (at + 0.5F).cast<int>().min(last_);
        return kinds_[nearest.x() + nearest.y() * row_ + nearest.z() * slice_];
    }

    /// Returns the gradient per mm, along the axes of the scan.
    Eigen::Vector3f gradient(const Eigen::Array3f& at) const
    {
        Eigen::Vector3f slope;
        for (int axis = 0; axis < 3; ++axis) {
            Eigen::Array3f before = at;
            Eigen::Array3f after = at;
            before[axis] = std::max(0.0F, at[axis] - 1.0F);
            after[axis] = std::min(static_cast<float>(last_[axis]), at[axis] + 1.0F);
            slope[axis] = (value(after) - value(before)) / (2.0F * spacing_[axis]);
        }
        return slope;
    }

private:
    const std::int16_t* values_;
    const std::uint8_t* kinds_;
    Eigen::Array3i last_;
    std::ptrdiff_t row_, slice_;
    Eigen::Array3f spacing_;
};

/// The part of a ray inside the scan or one of its blocks, in mm along the ray.
struct RaySpan {
    float from = 0.0F;
    float to = 0.0F;
};

RaySpan within(const Eigen::Array3f& start, const Eigen::Array3f& perMm, const Eigen::Array3f& low,
               const Eigen::Array3f& high)
{
    RaySpan inside{-std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(perMm[axis]) < 1e-7F) {
            if (start[axis] < low[axis] || start[axis] > high[axis]) {
                return {1.0F, 0.0F};
            }
            continue;
        }
        const float a = (low[axis] - start[axis]) / perMm[axis];
        const float b = (high[axis] - start[axis]) / perMm[axis];
        inside.from = std::max(inside.from, std::min(a, b));
        inside.to = std::min(inside.to, std::max(a, b));
    }
    return inside;
}

class ScanRenderer {
public:
    ScanRenderer(const PreparedVolume& scan, const ScanAppearance& appearance, const ParallelProjection& projection,
                 double stepFraction)
        : scan_(scan),
          projection_(projection),
          stepMm_(static_cast<float>(stepFraction * scan.volume.geometry.spacingMm.minCoeff())),
          transferFunction_(scan, appearance, stepMm_),
          interpolator_(scan)
    {
        const Eigen::Affine3d voxelFromPatient = scan.volume.geometry.patientFromVoxel().inverse();
        toVoxel_ = voxelFromPatient;
        perMm_ = (voxelFromPatient.linear() * -projection.toViewer()).cast<float>().array();
        light_ = (scan.volume.geometry.direction.transpose() * projection.toViewer()).cast<float>();
        lastVoxel_ = (scan.volume.geometry.size.array() - 1).cast<float>();
        for (const PreparedVolume::Block& block : scan.blocks) {
            isVisible_.push_back(transferFunction_.isVisible(block) ? 1 : 0);
        }
    }

    void renderRow(int y, Image2d<Rgba>& image) const
    {
        for (int x = 0; x < projection_.width; ++x) {
            const Eigen::Vector3d place =
                projection_.centerInPatient +
                projection_.mmPerPx * ((x + 0.5 - 0.5 * projection_.width) * projection_.right +
                                       (y + 0.5 - 0.5 * projection_.height) * projection_.up);
            image.at(x, y) = cast((toVoxel_ * place).cast<float>().array());
        }
    }

private:
    Rgba cast(const Eigen::Array3f& start) const
    {
        const RaySpan inside = within(start, perMm_, Eigen::Array3f::Zero(), lastVoxel_);
        Rgb color{};
        float opacity = 0.0F;
        // All rays sample at whole steps from a common plane, which keeps surfaces smooth from pixel to pixel.
        for (float t = std::ceil(inside.from / stepMm_) * stepMm_; t <= inside.to && opacity < opaqueThreshold;) {
            const Eigen::Array3f at = (start + t * perMm_).max(0.0F).min(lastVoxel_);
            const float skipMm = emptyBlockLength(at);
            if (skipMm > 0.0F) {
                t += std::max(1.0F, std::ceil(skipMm / stepMm_)) * stepMm_;
                continue;
            }
            add(at, color, opacity);
            t += stepMm_;
        }
        const auto byte = [](float share) {
            return static_cast<std::uint8_t>(std::min(255.0F, 255.0F * share + 0.5F));
        };
        return {byte(color[0]), byte(color[1]), byte(color[2]), byte(opacity)};
    }

    void add(const Eigen::Array3f& at, Rgb& color, float& opacity) const
    {
        const float value = interpolator_.value(at);
        const std::uint8_t kind = interpolator_.kind(at);
        const float here = (1.0F - opacity) * transferFunction_.opacity(value, kind);
        if (here <= 0.0F) {
            return;
        }
        const Eigen::Vector3f slope = interpolator_.gradient(at);
        const float steepness = slope.norm();
        const float facing = steepness > flatGradient ? std::abs(slope.dot(light_)) / steepness : 1.0F;
        const float light = ambient + (1.0F - ambient) * facing;
        const Rgb tone = transferFunction_.color(value, kind);
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] += here * light * tone[c];
        }
        opacity += here;
    }

    /// Returns the distance to the end of the block if nothing in the block is visible; otherwise 0.
    float emptyBlockLength(const Eigen::Array3f& at) const
    {
        const Eigen::Array3i block =
            (at / static_cast<float>(blockSideVoxels)).cast<int>().min(scan_.blockCount.array() - 1);
        const int index = (block.z() * scan_.blockCount.y() + block.y()) * scan_.blockCount.x() + block.x();
        if (isVisible_[static_cast<std::size_t>(index)] != 0) {
            return 0.0F;
        }
        const Eigen::Array3f low = static_cast<float>(blockSideVoxels) * block.cast<float>();
        return std::max(1e-3F, within(at, perMm_, low, low + static_cast<float>(blockSideVoxels)).to);
    }

    const PreparedVolume& scan_;
    ParallelProjection projection_;
    float stepMm_;
    TransferFunction transferFunction_;
    VoxelInterpolator interpolator_;
    Eigen::Affine3d toVoxel_;
    Eigen::Array3f perMm_;   // voxels per mm along the ray
    Eigen::Vector3f light_;   // direction toward the viewer, along the axes of the scan
    Eigen::Array3f lastVoxel_;
    std::vector<std::uint8_t> isVisible_;
};

}   // namespace

std::optional<Image2d<Rgba>> renderScan(const PreparedVolume& scan, const ScanAppearance& appearance,
                                        const ParallelProjection& projection, double stepFraction,
                                        const std::function<bool()>& shouldContinue)
{
    if (!shouldContinue()) {
        return std::nullopt;
    }
    Image2d<Rgba> image(std::max(0, projection.width), std::max(0, projection.height));
    if (!projection.isDefined()) {
        return image;
    }
    const ScanRenderer renderer(scan, appearance, projection, stepFraction);
    const bool isWhole = parallelFor(
        static_cast<std::size_t>(projection.height), threadCount(0),
        [&](std::size_t y) { renderer.renderRow(static_cast<int>(y), image); },
        [&](double) { return shouldContinue(); });
    return isWhole ? std::optional(std::move(image)) : std::nullopt;
}

}   // namespace angiopose::core
