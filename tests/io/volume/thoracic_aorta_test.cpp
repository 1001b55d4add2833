#include "core/tracing/volume/trace_vessels.h"
#include "io/volume_file.h"
#include "tests/support/altered_scan.h"
#include "tests/support/test_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace angiopose;

namespace {

/// The dissected aorta of the thoracic CTA, with a stent in its true lumen distal to the arch.
class ThoracicAorta : public testing::Test {
protected:
    void SetUp() override
    {
        ANGIOPOSE_NEEDS_DATA("thoracic-aorta-cta");
        auto scan = io::readVolume(test::dataFile("thoracic-aorta-cta/ct_cropped.nii.gz").string());
        ASSERT_TRUE(scan) << scan.error().message;
        scan_ = std::move(scan).value().volume;
    }

    static core::LabelVolume mask(const std::string& name)
    {
        auto read = io::readLabels(test::dataFile("thoracic-aorta-cta/" + name + ".nii.gz").string());
        EXPECT_TRUE(read) << read.error().message;
        return read ? std::move(read).value() : core::LabelVolume();
    }

    core::Volume scan_;
};

/// Radius of a disc with the area of the set voxels of slice `k` behind row `j`.
double radiusInSlice(const core::LabelVolume& mask, int k, int j)
{
    int count = 0;
    for (; j < mask.geometry.size.y(); ++j) {
        for (int i = 0; i < mask.geometry.size.x(); ++i) {
            count += mask.at(i, j, k) != 0 ? 1 : 0;
        }
    }
    return std::sqrt(count * mask.geometry.spacingMm.x() * mask.geometry.spacingMm.y() / std::numbers::pi);
}

TEST_F(ThoracicAorta, IsAboutAsWideInItsStentAsItsMask)
{
    const core::LabelVolume lumen = mask("aorta_true_lumen");
    const auto traced = core::traceVessels(scan_);
    ASSERT_TRUE(traced) << traced.error().message;
    const Eigen::Affine3d voxelFromPatient = scan_.geometry.patientFromVoxel().inverse();
    constexpr int behindAscending = 80;
    for (const int slice : {105, 112, 119, 126}) {
        double nearest = 1.5;   // in slices
        double radiusMm = 0.0;
        for (const core::VesselBranch& branch : traced.value().tree.branches) {
            for (std::size_t n = 0; n < branch.pointsInPatient.size(); ++n) {
                const Eigen::Vector3d at = voxelFromPatient * branch.pointsInPatient[n];
                if (at.y() > behindAscending && std::abs(at.z() - slice) < nearest) {
                    nearest = std::abs(at.z() - slice);
                    radiusMm = branch.radiusMm[n];
                }
            }
        }
        const double expectedMm = radiusInSlice(lumen, slice, behindAscending);
        EXPECT_NEAR(radiusMm, expectedMm, 0.2 * expectedMm) << slice;
    }
}

TEST_F(ThoracicAorta, DoesNotLeadIntoThePulmonaryArteryBesideIt)
{
    const core::LabelVolume aorta = mask("organ_aorta_T264");
    const Eigen::Affine3d voxelFromPatient = aorta.geometry.patientFromVoxel().inverse();
    for (const test::ScanChange& change : test::scanChanges()) {
        if (change.name != "as it is" && change.name != "slices of 2 mm" && change.name != "upper 3/4") {
            continue;
        }
        const auto traced = core::traceVessels(change.apply(scan_));
        ASSERT_TRUE(traced) << traced.error().message;
        bool holdsAorta = false;
        for (const core::VesselBranch& branch : traced.value().tree.branches) {
            for (const Eigen::Vector3d& point : branch.pointsInPatient) {
                const Eigen::Vector3i at = (voxelFromPatient * point).array().round().cast<int>();
                holdsAorta = holdsAorta || (aorta.geometry.contains(at) && aorta.at(at.x(), at.y(), at.z()) != 0);
                // To the left and right of the heart there are only pulmonary vessels.
                const bool isInLung = at.z() > 60 && at.z() < 125 && (at.x() < 25 || at.x() > 84);
                EXPECT_FALSE(isInLung) << change.name << " " << at.transpose();
            }
        }
        EXPECT_TRUE(holdsAorta) << change.name;
    }
}

}   // namespace
