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
    EXPECT_EQ(findPatientMismatch(doe, patient("0815 ", "Doe^John ", "")), "");
    EXPECT_EQ(findPatientMismatch(doe, {}), "");
    EXPECT_EQ(findPatientMismatch({}, {}), "");
}

TEST(PatientMatch, SaysWhatDiffersWithoutNamingAnybody)
{
    const std::string text =
        findPatientMismatch(patient("0815", "Doe^John", "1950-01-02"), patient("4711", "Roe^Jane", "1950-01-02"));
    EXPECT_NE(text.find("(number, name differ)"), std::string::npos);
    EXPECT_EQ(text.find("Doe"), std::string::npos);
    EXPECT_EQ(text.find("4711"), std::string::npos);
}

TEST(PatientMatch, SexDiffersOnlyWhereBothSayOneOfTwo)
{
    StudyIdentity he, she, other;
    he.sex = "M";
    she.sex = "F";
    other.sex = "O";
    EXPECT_NE(findPatientMismatch(he, she).find("(sex differs)"), std::string::npos);
    EXPECT_EQ(findPatientMismatch(he, other), "");
    EXPECT_EQ(findPatientMismatch(he, {}), "");
}

TEST(PatientMatch, OppositeSidesOfTheBodyAreNamed)
{
    StudyIdentity left, right, both;
    left.laterality = "L";
    right.laterality = "R";
    both.laterality = "B";
    EXPECT_NE(findSideMismatch(left, right).find("left side"), std::string::npos);
    EXPECT_NE(findSideMismatch(right, left).find("right side"), std::string::npos);
    EXPECT_EQ(findSideMismatch(left, both), "");
    EXPECT_EQ(findSideMismatch(left, {}), "");
    left.sex = "F";
    right.sex = "M";
    EXPECT_EQ(findMismatch(left, right), findPatientMismatch(left, right) + " " + findSideMismatch(left, right));
    EXPECT_EQ(findMismatch(left, left), "");
}

}   // namespace angiopose::core