#pragma once

#include "io/volume_file.h"
#include "tests/io/series/dicom_slices.h"
#include "tests/support/axis_orders.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <vector>

namespace angiopose::test {

/// The slice of `volume` at layer k, as stored by a scanner.
inline CtSlice sliceOf(const core::Volume& volume, int k)
{
    const core::VolumeGeometry& geometry = volume.geometry;
    CtSlice slice;
    slice.columns = geometry.size.x();
    slice.rows = geometry.size.y();
    slice.columnSpacingMm = geometry.spacingMm.x();
    slice.rowSpacingMm = geometry.spacingMm.y();
    slice.intercept = volume.intercept;
    const Eigen::Vector3d position = geometry.patientFromVoxel() * Eigen::Vector3d(0, 0, k);
    slice.position.assign(position.data(), position.data() + 3);
    slice.orientation.assign(geometry.direction.data(), geometry.direction.data() + 6);
    slice.instanceNumber = k + 1;
    slice.sopInstanceUid = "1.2.3." + std::to_string(k + 1);
    const auto first = volume.voxels.begin() + static_cast<std::ptrdiff_t>(geometry.index(0, 0, k));
    slice.pixels.assign(first, first + static_cast<std::ptrdiff_t>(slice.columns) * slice.rows);
    return slice;
}

inline core::Volume ctPhantom()
{
    core::Volume volume = countedVolume({8, 9, 10});
    volume.intercept = -1024.0;
    return volume;
}

/// Writes slices under names unrelated to their order.
inline void writeShuffled(const TemporaryFolder& folder, const std::vector<CtSlice>& slices)
{
    for (std::size_t i = 0; i < slices.size(); ++i) {
        folder.write(std::to_string(7919 * (i + 1) % 1000) + "_" + std::to_string(i), ctSlice(slices[i]));
    }
}

inline std::vector<CtSlice> allSlices(const core::Volume& volume)
{
    std::vector<CtSlice> slices;
    for (int k = 0; k < volume.geometry.size.z(); ++k) {
        slices.push_back(sliceOf(volume, k));
    }
    return slices;
}

inline io::LoadedVolume readFolder(const TemporaryFolder& folder)
{
    auto loaded = io::readVolume(folder.file(""));
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message.text());
    return loaded ? std::move(loaded).value() : io::LoadedVolume{};
}

inline bool mentions(const core::Messages& warnings, const std::string& words)
{
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const core::Message& warning) { return warning.text().find(words) != std::string::npos; });
}

}   // namespace angiopose::test
