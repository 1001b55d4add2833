#include "core/registration/deformable/deform_vessels.h"
#include "core/registration/register_views.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <string>

namespace angiopose::core {
namespace {

/// A random view of a small tree: empty, with a single point, unmatched, short, truncated or of another size.
class OddViews {
public:
    explicit OddViews(std::uint64_t seed)
        : random_(seed), tree_(simulateTree(seed, {.branchCount = 2 + below(4), .extentMm = 90.0}))
    {
        const std::size_t count = static_cast<std::size_t>(2 + below(3));
        for (std::size_t k = 0; k < count; ++k) {
            inputs.push_back(view(k, static_cast<Kind>(below(7))));
        }
    }

    std::vector<DeformableView> deformable() const
    {
        std::vector<DeformableView> views;
        for (const RegistrationInput& input : inputs) {
            views.push_back({input, input.initialCameraFromPatient, 0});
        }
        return views;
    }

    std::vector<RegistrationInput> inputs;

private:
    enum class Kind { Whole, Noisy, Unmatched, Empty, OnePoint, Piece, BehindTheSource };

    int below(int count) { return static_cast<int>(random_.uniform() * count); }

    RegistrationInput view(std::size_t number, Kind kind)
    {
        const Eigen::Vector3d centroid = centroidInPatient(tree_);
        ProjectionCamera camera{-900.0, 900.0, 0.0, 0.0, 33 + below(480), 17 + below(480)};
        camera.cx = 0.5 * camera.width;
        camera.cy = 0.5 * camera.height;
        RigidTransform truth;
        truth.rotation = expSo3({0.2, 1.1 * static_cast<double>(number), random_.normal()});
        truth.translation = Eigen::Vector3d(random_.normal(), random_.normal(), 700.0) - truth.rotation * centroid;
        RigidTransform start = perturbAboutCentroid(truth, centroid, 1.5, 4.0, random_);
        Centerline2d target = projectTree(tree_, camera, truth);
        if (kind == Kind::BehindTheSource) {
            start.translation.z() -= 1500.0;
        }
        change(target, kind);
        return {tree_, target, camera, start, {}, {}};
    }

    void change(Centerline2d& target, Kind kind)
    {
        if (kind == Kind::Empty) {
            target.curves.clear();
        } else if (kind == Kind::OnePoint) {
            target.curves.resize(1);
            target.curves.front().pointsPx.resize(1);
            target.curves.front().radiusPx.clear();
        } else if (kind == Kind::Piece) {
            target.curves.resize(1);
            target.curves.front().pointsPx.resize(std::min<std::size_t>(8, target.curves.front().pointsPx.size()));
            target.curves.front().radiusPx.clear();
        }
        for (Curve2d& curve : target.curves) {
            for (Eigen::Vector2d& point : curve.pointsPx) {
                point += kind == Kind::Unmatched ? Eigen::Vector2d(-900.0, 700.0) : Eigen::Vector2d::Zero();
                point.x() += kind == Kind::Noisy ? 1.5 * random_.normal() : 0.0;
            }
        }
    }

    CounterRandom random_;
    VesselTree tree_;
};

/// Number of test rounds: 12, or the number set in the environment.
std::uint64_t runCount()
{
    const char* asked = std::getenv("ANGIOPOSE_ODD_VIEWS");
    return asked ? std::stoull(asked) : 12;
}

// Intended for the address sanitizer: whatever the views contain, a joint registration returns a pose for each view or
// an error.
TEST(OddViews, EndWithAPoseOfEachViewOrAnError)
{
    std::uint64_t refused = 0;
    for (std::uint64_t seed = 1; seed <= runCount(); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const OddViews odd(seed);
        RegistrationOptions options;
        options.deformation = Deformation::Always;
        const auto joint = registerViews(odd.inputs, options, {});
        const auto deformed = deformVessels(odd.deformable(), {.geometryDeg = 0.5, .geometryMm = 1.5});
        refused += joint ? 0 : 1;
        for (const auto& result : {joint ? joint.value().corrections.size() : odd.inputs.size(),
                                   joint ? joint.value().views.size() : odd.inputs.size(),
                                   deformed ? deformed.value().viewPoses.size() : odd.inputs.size()}) {
            EXPECT_EQ(result, odd.inputs.size());
        }
        if (joint) {
            for (const RegistrationResult& view : joint.value().views) {
                EXPECT_TRUE(view.cameraFromPatient.matrix().allFinite());
            }
        }
        EXPECT_TRUE(!deformed || deformed.value().cameraFromPatient.matrix().allFinite());
    }
    EXPECT_LT(refused, runCount());
}

}   // namespace
}   // namespace angiopose::core
