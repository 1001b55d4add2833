#include "angiopose/volume.h"

#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "io/vessel_input_file.h"
#include "io/volume_file.h"

#include <algorithm>

namespace angiopose::library {

core::VolumeGeometry toCore(const VolumeGeometry& geometry)
{
    const auto& [size, spacing, origin, direction] = geometry;
    if (*std::min_element(size.begin(), size.end()) < 0) {
        throw Error("library.volume-size", "The size of a volume cannot be negative.");
    }
    return {{size[0], size[1], size[2]}, spacing, origin, direction};
}

VolumeGeometry toPublic(const core::VolumeGeometry& geometry)
{
    const auto& [size, spacing, origin, direction] = geometry;
    return {{size.x(), size.y(), size.z()}, spacing, origin, direction};
}

core::VesselTracingOptions toCore(const VesselTracingOptions& options)
{
    const auto& [threshold, seeds, avoid, root, minLength, minRadius, spacing, tubesOnly, threads, pieces, loops] =
        options;
    return {threshold,
            seeds,
            avoid,
            root,
            minLength,
            minRadius,
            spacing,
            static_cast<core::TracedPieces>(pieces),
            static_cast<core::VesselLoops>(loops),
            tubesOnly,
            threads};
}

core::VesselInput vesselInputOf(const std::string& path, const VesselReadOptions& options)
{
    core::VesselInput input;
    input.kind = valueOf(io::vesselInputKindOf(path));
    if (!options.labels.empty() && input.kind == core::VesselInputKind::Volume) {
        input.kind = core::VesselInputKind::Segmentation;
    }
    input.labels = options.labels;
    input.seriesId = options.seriesId;
    input.unitMm = options.unitMm;
    input.tracing = toCore(options.tracing);
    return input;
}

namespace {

void checkVoxels(std::size_t count, const VolumeGeometry& geometry)
{
    if (count != geometry.voxelCount()) {
        throw Error("library.voxel-count", "The volume has " + std::to_string(count) +
                                               " voxels, but its size requires " +
                                               std::to_string(geometry.voxelCount()) + ".");
    }
    const core::VolumeGeometry grid = toCore(geometry);
    if (!grid.spacingMm.allFinite() || grid.spacingMm.minCoeff() <= 0.0 || !grid.originInPatient.allFinite() ||
        !grid.direction.allFinite()) {
        throw Error(
            "library.volume-spacing",
            "The spacing, origin and directions of a volume must be finite numbers, and the spacing must be positive.");
    }
}

TracedVessels publicVessels(const core::VesselTree& tree, core::VoxelMask lumen, double threshold,
                            const core::Messages& warnings)
{
    return {toPublic(tree), toPublic(lumen.geometry), std::move(lumen.voxels), threshold, toPublic(warnings)};
}

TracedVessels publicVessels(core::TracedVessels traced)
{
    return publicVessels(traced.tree, std::move(traced.lumen), traced.threshold, traced.warnings);
}

}   // namespace
}   // namespace angiopose::library

namespace angiopose {

std::size_t VolumeGeometry::voxelCount() const
{
    return library::toCore(*this).voxelCount();
}

Volume::Volume(std::span<const std::int16_t> voxels, const VolumeGeometry& geometry, double slope, double intercept)
{
    library::checkVoxels(voxels.size(), geometry);
    auto content = std::make_shared<core::Volume>();
    content->geometry = library::toCore(geometry);
    content->voxels.assign(voxels.begin(), voxels.end());
    content->slope = slope;
    content->intercept = intercept;
    content_ = std::move(content);
}

Volume::Volume(std::shared_ptr<const core::Volume> content) : content_(std::move(content)) {}

VolumeGeometry Volume::geometry() const
{
    return library::toPublic(content_->geometry);
}

std::span<const std::int16_t> Volume::voxels() const
{
    return content_->voxels;
}

double Volume::slope() const
{
    return content_->slope;
}

double Volume::intercept() const
{
    return content_->intercept;
}

Volume readVolume(const std::string& path, const std::string& seriesId, const Observer& observe)
{
    library::ObserverAdapter relay(observe);
    io::LoadedVolume loaded = relay.resultOf(io::readVolume(path, seriesId, relay.reading("reading")));
    return Volume(std::make_shared<const core::Volume>(std::move(loaded.volume)));
}

void writeVolume(const Volume& volume, const std::string& path)
{
    library::check(io::writeVolume(*volume.content(), path));
}

TracedVessels traceVessels(const Volume& volume, const VesselTracingOptions& options, const Observer& observe)
{
    library::ObserverAdapter relay(observe);
    return library::publicVessels(
        relay.resultOf(core::traceVessels(*volume.content(), library::toCore(options), relay.tracing())));
}

TracedVessels traceMask(std::span<const std::uint8_t> mask, const VolumeGeometry& geometry,
                        const VesselTracingOptions& options, const Observer& observe)
{
    library::checkVoxels(mask.size(), geometry);
    core::VoxelMask voxels;
    voxels.geometry = library::toCore(geometry);
    voxels.voxels.assign(mask.begin(), mask.end());
    library::ObserverAdapter relay(observe);
    return library::publicVessels(relay.resultOf(core::traceMask(voxels, library::toCore(options), relay.tracing())));
}

TracedVessels readVessels(const std::string& path, const VesselReadOptions& options, const Observer& observe)
{
    const core::VesselInput input = library::vesselInputOf(path, options);
    library::ObserverAdapter relay(observe);
    io::LoadedVessels loaded = relay.resultOf(io::readVessels(path, input, relay.reading("reading")));
    return library::publicVessels(loaded.tree, std::move(loaded.lumen), loaded.threshold, loaded.warnings);
}

}   // namespace angiopose
