#include "core/imaging/patient_match.h"

#include <gtest/gtest.h>

namespace core {
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

}   // namespace core
