#include "tests/io/series/ct_phantom.h"

#include <gtest/gtest.h>
#include <algorithm>

using namespace angiopose;

namespace {

using test::allSlices;
using test::ctPhantom;
using test::CtSlice;
using test::mentions;
using test::readFolder;
using test::TemporaryFolder;
using test::writeShuffled;

TEST(UnevenSeries, AMissingSliceIsFilledAndNamed)
{
    const TemporaryFolder folder;
    core::Volume phantom = ctPhantom();   // linear along k, so that the mean of two slices is known
    std::vector<CtSlice> slices = allSlices(phantom);
    slices.erase(slices.begin() + 4);
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_LT(test::largestDisplacement(phantom, loaded.volume), 1e-6);
    EXPECT_TRUE(mentions(loaded.warnings, "1 of 10 slices is missing (after slice 4)"));
}

TEST(UnevenSeries, UnevenSpacingIsResampled)
{
    const TemporaryFolder folder;
    const core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    const Eigen::Vector3d along = phantom.geometry.direction.col(2);
    const std::vector<double> places = {0, 1.25, 2.5, 3.75, 5, 5.8, 7.6, 8.75, 10, 11.25};
    for (std::size_t k = 0; k < slices.size(); ++k) {
        const Eigen::Vector3d position = phantom.geometry.originInPatient + places[k] * along;
        slices[k].position.assign(position.data(), position.data() + 3);
        std::fill(slices[k].pixels.begin(), slices[k].pixels.end(), static_cast<std::int16_t>(100.0 * places[k]));
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_TRUE(mentions(loaded.warnings, "unevenly spaced (0.8 to 1.8 mm)"));
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    for (int k = 0; k < geometry.size.z(); ++k) {
        const double place = k * geometry.spacingMm.z();
        EXPECT_NEAR(loaded.volume.value(geometry.index(3, 3, k)) + 1024.0, 100.0 * place, 13.0) << k;
    }
}

TEST(UnevenSeries, ATiltedGantryIsShiftedUpright)
{
    const TemporaryFolder folder;
    core::VolumeGeometry geometry;
    geometry.size = {16, 40, 12};
    geometry.spacingMm = {1, 1, 2};
    const double tilt = 0.25;   // backward lean of the slices' tops, per mm
    // A straight rod along z in the patient: with a tilted gantry it shifts across the rows.
    std::vector<CtSlice> slices;
    for (int k = 0; k < 12; ++k) {
        CtSlice slice;
        slice.columns = 16;
        slice.rows = 40;
        slice.columnSpacingMm = slice.rowSpacingMm = 1.0;
        slice.sopInstanceUid = "1.2.3." + std::to_string(k);
        slice.position = {0.0, -tilt * 2.0 * k, 2.0 * k};
        slice.pixels.assign(16 * 40, 0);
        for (int j = 0; j < 40; ++j) {
            const double y = slice.position[1] + j;
            slice.pixels[static_cast<std::size_t>(16 * j + 5)] =
                static_cast<std::int16_t>(1000.0 * std::max(0.0, 1.0 - std::abs(y - 10.0) / 3.0));
        }
        slices.push_back(slice);
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    EXPECT_TRUE(mentions(loaded.warnings, "14°"));
    const core::VolumeGeometry& upright = loaded.volume.geometry;
    EXPECT_TRUE(upright.direction.isIdentity(1e-9));
    for (int k = 0; k < upright.size.z(); ++k) {
        double weight = 0.0, sum = 0.0;
        for (int j = 0; j < upright.size.y(); ++j) {
            const double value = std::max(0.0, loaded.volume.value(upright.index(5, j, k)) + 1000.0);
            weight += value;
            sum += value * (upright.patientFromVoxel() * Eigen::Vector3d(5, j, k)).y();
        }
        EXPECT_NEAR(sum / weight, 10.0, 0.15) << "layer " << k;
    }
}

TEST(UnevenSeries, DifferentScalesKeepTheirValues)
{
    const TemporaryFolder folder;
    core::Volume phantom = ctPhantom();
    std::vector<CtSlice> slices = allSlices(phantom);
    for (std::size_t k = 0; k < slices.size(); k += 2) {   // stored with halved values
        slices[k].slope = 2.0;
        slices[k].intercept = -1024.0;
        for (std::int16_t& pixel : slices[k].pixels) {
            pixel = static_cast<std::int16_t>(2 * (pixel / 2) / 2);
        }
    }
    writeShuffled(folder, slices);

    const io::LoadedVolume loaded = readFolder(folder);

    for (int k = 0; k < 10; ++k) {
        const std::size_t at = phantom.geometry.index(3, 4, k);
        EXPECT_NEAR(loaded.volume.value(at), phantom.value(at), k % 2 == 0 ? 1.0 : 0.0) << k;
    }
}

}   // namespace
