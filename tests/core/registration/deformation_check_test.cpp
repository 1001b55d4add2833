#include "core/registration/deformation_check.h"

#include "core/messages/messages.h"
#include "core/registration/registration.h"
#include "tests/support/clean_case.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

/// One view of a tree whose part below the centroid was moved across the ray by `byMm`.
RegistrationInput halfMoved(const test::CleanCase& clean, double byMm)
{
    const double middle = centroidInPatient(clean.tree).z();
    const Eigen::Vector3d aside = clean.truth.rotation.transpose() * Eigen::Vector3d::UnitX();
    VesselTree moved = clean.tree;
    for (VesselBranch& branch : moved.branches) {
        for (Eigen::Vector3d& point : branch.pointsInPatient) {
            point += byMm / (1.0 + std::exp((point.z() - middle) / 2.0)) * aside;
        }
    }
    RegistrationInput input = clean.fromNearby(4);
    input.target = projectTree(moved, clean.camera, clean.truth);
    return input;
}

const Message* find(const Messages& messages, const MessageEntry& entry)
{
    const auto found = std::ranges::find_if(messages, [&](const Message& message) { return message.is(entry); });
    return found == messages.end() ? nullptr : &*found;
}

TEST(DeformationDoubt, ARigidTreeIsNotAsked)
{
    const test::CleanCase clean(3);
    const RegistrationInput input = clean.fromNearby(4);
    RegistrationOptions off;
    off.deformation = Deformation::Off;
    const RegistrationResult asUsual = registerVessels(input).value();
    const RegistrationResult without = registerVessels(input, off).value();

    EXPECT_FALSE(asUsual.deformed);
    EXPECT_TRUE(asUsual.trustworthy);
    EXPECT_EQ(asUsual.uncertainty.covariance, without.uncertainty.covariance);
}

TEST(DeformationDoubt, AHalfThatMovedShakesTrust)
{
    const test::CleanCase clean(3);
    const RegistrationInput input = halfMoved(clean, 8.0);
    RegistrationOptions off;
    off.deformation = Deformation::Off;
    const RegistrationResult result = registerVessels(input).value();
    const RegistrationResult without = registerVessels(input, off).value();

    EXPECT_EQ(result.cameraFromPatient.matrix(), without.cameraFromPatient.matrix());
    EXPECT_FALSE(without.deformed);
    ASSERT_TRUE(result.deformed);
    EXPECT_NE(result.deformed->verdict, DeformationVerdict::Rigid);
    EXPECT_FALSE(result.trustworthy);
    const Message* said =
        find(result.warnings, result.deformed->verdict == DeformationVerdict::Deformed ? messages::deformationRigidOff
                                                                                       : messages::deformationMayBeOff);
    ASSERT_NE(said, nullptr);
    EXPECT_EQ(said->severity(), Severity::Warning);
    EXPECT_GT(std::get<Quantity>(said->arguments()[1]).value, 3.0) << said->text();
    EXPECT_GT(result.uncertainty.inPlaneMm, 2.0 * without.uncertainty.inPlaneMm);
    EXPECT_GT(result.deformed->rigid.meanMm, 1.0);
}

TEST(DeformationDoubt, StoppedWhileDeformationIsNotTrusted)
{
    const test::CleanCase clean(3);
    const RegistrationInput input = clean.from(clean.truth);
    RegistrationOptions always;
    always.deformation = Deformation::Always;
    const auto stopAtDeformation = [](const IterationReport& report) {
        return report.stage == "bending" ? ObserverDecision::Stop : ObserverDecision::Continue;
    };
    const RegistrationResult toTheEnd = registerVessels(input, always).value();
    const RegistrationResult stopped = registerVessels(input, always, stopAtDeformation).value();

    EXPECT_TRUE(toTheEnd.trustworthy);
    EXPECT_EQ(stopped.cameraFromPatient.matrix(), toTheEnd.cameraFromPatient.matrix());
    EXPECT_EQ(stopped.stopReason, StopReason::StoppedByUser);
    EXPECT_FALSE(stopped.trustworthy);
    const Message* said = find(stopped.warnings, messages::deformationStopped);
    ASSERT_NE(said, nullptr);
    EXPECT_EQ(said->severity(), Severity::Warning);
}

TEST(DeformationDoubt, LocksAreNotDeformedByThemselves)
{
    const test::CleanCase clean(3);
    RegistrationOptions locked;
    locked.locks[static_cast<std::size_t>(PoseAxis::AlongRay)] = true;
    EXPECT_FALSE(registerVessels(halfMoved(clean, 8.0), locked).value().deformed);
}

TEST(DeformationDoubt, AlwaysAsksWhateverTheMethod)
{
    const test::CleanCase clean(3);
    const RegistrationInput input = halfMoved(clean, 8.0);
    RegistrationOptions always;
    always.method = "dt-icp";
    always.deformation = Deformation::Always;
    EXPECT_TRUE(registerVessels(input, always).value().deformed);
}

}   // namespace
}   // namespace angiopose::core
