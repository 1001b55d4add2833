#include "core/imaging/patient_match.h"

#include <gtest/gtest.h>

namespace angiopose::core {
namespace {

StudyIdentity patient(const char* id, const char* name, const char* birthDate)
{
    StudyIdentity identity;
    identity.patientId = id;
    identity.patientName = name;
    identity.birthDate = birthDate;
    return identity;
}

}   // namespace

TEST(PatientMatch, SpellingAndMissingValuesAreNoMismatch)
{
    const StudyIdentity doe = patient("0815", "DOE^JOHN", "1950-01-02");
    EXPECT_FALSE(findPatientMismatch(doe, patient("0815 ", "Doe^John ", "")));
    EXPECT_FALSE(findPatientMismatch(doe, {}));
    EXPECT_FALSE(findPatientMismatch({}, {}));
}

TEST(PatientMatch, SaysWhatDiffersWithoutNamingAnybody)
{
    const auto mismatch =
        findPatientMismatch(patient("0815", "Doe^John", "1950-01-02"), patient("4711", "Roe^Jane", "1950-01-02"));
    ASSERT_TRUE(mismatch);
    const std::string text = mismatch->text();
    EXPECT_NE(text.find("(patient ID, name differ)"), std::string::npos);
    EXPECT_EQ(text.find("Doe"), std::string::npos);
    EXPECT_EQ(text.find("4711"), std::string::npos);
}

TEST(PatientMatch, SexDiffersOnlyWhereBothSayOneOfTwo)
{
    StudyIdentity he, she, other;
    he.sex = "M";
    she.sex = "F";
    other.sex = "O";
    EXPECT_NE(findPatientMismatch(he, she).value().text().find("(sex differs)"), std::string::npos);
    EXPECT_FALSE(findPatientMismatch(he, other));
    EXPECT_FALSE(findPatientMismatch(he, {}));
}

TEST(PatientMatch, OppositeSidesOfTheBodyAreNamed)
{
    StudyIdentity left, right, both;
    left.laterality = "L";
    right.laterality = "R";
    both.laterality = "B";
    EXPECT_NE(findLateralityMismatch(left, right).value().text().find("left side"), std::string::npos);
    EXPECT_NE(findLateralityMismatch(right, left).value().text().find("right side"), std::string::npos);
    EXPECT_FALSE(findLateralityMismatch(left, both));
    EXPECT_FALSE(findLateralityMismatch(left, {}));
    left.sex = "F";
    right.sex = "M";
    EXPECT_EQ(findMismatch(left, right),
              (Messages{findPatientMismatch(left, right).value(), findLateralityMismatch(left, right).value()}));
    EXPECT_TRUE(findMismatch(left, left).empty());
}

}   // namespace angiopose::core
