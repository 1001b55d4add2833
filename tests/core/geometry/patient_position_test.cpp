#include "core/geometry/patient_position.h"

#include "core/geometry/rigid_transform.h"

#include <gtest/gtest.h>
#include <array>

using namespace angiopose;

namespace {

using namespace core;

constexpr std::array allPositions{PatientPosition::HFS,  PatientPosition::HFP, PatientPosition::HFDR,
                                  PatientPosition::HFDL, PatientPosition::FFS, PatientPosition::FFP,
                                  PatientPosition::FFDR, PatientPosition::FFDL};

const Eigen::Vector3d towardsLeft(1.0, 0.0, 0.0);
const Eigen::Vector3d towardsBack(0.0, 1.0, 0.0);
const Eigen::Vector3d towardsHead(0.0, 0.0, 1.0);
const Eigen::Vector3d floorward = towardsBack;   // down, at the table; the back of a supine patient lies on it

CArm cArmAt(double primaryDeg, double secondaryDeg, double rollDeg, bool mirrored)
{
    CArm cArm;
    cArm.sourceToIsocenterMm = {750.0, Origin::User, ""};
    cArm.primaryAngleDeg = {primaryDeg, Origin::Header, ""};
    cArm.secondaryAngleDeg = {secondaryDeg, Origin::Header, ""};
    cArm.rollDeg = {rollDeg, Origin::User, ""};
    cArm.mirrored = {mirrored, Origin::User, ""};
    return cArm;
}

TEST(PatientPosition, IsReadAndWritten)
{
    for (const PatientPosition position : allPositions) {
        EXPECT_EQ(parsePatientPosition(toText(position)), position);
    }
    EXPECT_FALSE(parsePatientPosition(""));
    EXPECT_FALSE(parsePatientPosition("LFP"));
}

TEST(PatientPosition, TellsWhatLiesOnTheTable)
{
    const auto downward = [](PatientPosition position) { return (patientFromTable(position) * floorward).eval(); };
    EXPECT_EQ(downward(PatientPosition::HFS), towardsBack);
    EXPECT_EQ(downward(PatientPosition::FFS), towardsBack);
    EXPECT_EQ(downward(PatientPosition::HFP), -towardsBack);
    EXPECT_EQ(downward(PatientPosition::FFP), -towardsBack);
    EXPECT_EQ(downward(PatientPosition::HFDR), -towardsLeft);
    EXPECT_EQ(downward(PatientPosition::FFDR), -towardsLeft);
    EXPECT_EQ(downward(PatientPosition::HFDL), towardsLeft);
    EXPECT_EQ(downward(PatientPosition::FFDL), towardsLeft);
    for (const PatientPosition position : allPositions) {
        const Eigen::Matrix3d rotation = patientFromTable(position);
        EXPECT_DOUBLE_EQ(rotation.determinant(), 1.0);
        EXPECT_EQ(rotation * towardsHead, toText(position).starts_with("HF") ? towardsHead : (-towardsHead).eval());
    }
}

TEST(PatientPosition, AnglesToTypeGiveTheCameraThatTheTableReadingMeans)
{
    for (const PatientPosition position : allPositions) {
        for (const bool mirrored : {false, true}) {
            const CArm counted = cArmAt(35.0, -20.0, 8.0, mirrored);
            const auto reading = anglesFromTable(counted, position);
            if (position == PatientPosition::HFS) {
                EXPECT_FALSE(reading);
                continue;
            }
            ASSERT_TRUE(reading);
            const PatientAngles& angles = reading->angles;
            const CArm typed = cArmAt(angles.primaryDeg, angles.secondaryDeg, angles.rollDeg, mirrored);
            const Eigen::Matrix3d meant =
                cameraFromPatient(counted, Eigen::Vector3d::Zero()).value().rotation * reading->turn;
            EXPECT_TRUE(cameraFromPatient(typed, Eigen::Vector3d::Zero()).value().rotation.isApprox(meant, 1e-12))
                << toText(position);
        }
    }
}

TEST(PatientPosition, FeetFirstTurnsBothAnglesAndTheImage)
{
    const PatientAngles angles = anglesFromTable(cArmAt(30.0, 10.0, 0.0, false), PatientPosition::FFS)->angles;
    EXPECT_NEAR(angles.primaryDeg, -30.0, 1e-9);
    EXPECT_NEAR(angles.secondaryDeg, -10.0, 1e-9);
    EXPECT_NEAR(std::abs(angles.rollDeg), 180.0, 1e-9);
}

TEST(PatientPosition, MissingAnglesHaveNoOtherReading)
{
    CArm cArm = cArmAt(30.0, 10.0, 0.0, false);
    cArm.secondaryAngleDeg = {};
    EXPECT_FALSE(anglesFromTable(cArm, PatientPosition::FFS));
}

}   // namespace
