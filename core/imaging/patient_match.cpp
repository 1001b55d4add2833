#include "core/imaging/patient_match.h"

#include <algorithm>
#include <cctype>

namespace angiopose::core {
namespace {

/// Letters and digits in lower case: "DOE^JOHN " and "Doe^John" are one name.
std::string bare(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 128 || std::isalnum(byte) != 0) {
            result += static_cast<char>(std::tolower(byte));
        }
    }
    return result;
}

bool differs(const std::string& a, const std::string& b)
{
    const std::string first = bare(a), second = bare(b);
    return !first.empty() && !second.empty() && first != second;
}

}   // namespace

std::string findPatientMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    std::string reasons;
    int count = 0;
    const auto add = [&](bool isDifferent, const char* what) {
        if (isDifferent) {
            reasons += (reasons.empty() ? "" : ", ") + std::string(what);
            ++count;
        }
    };
    add(differs(scan.patientId, run.patientId), "number");
    add(differs(scan.patientName, run.patientName), "name");
    add(differs(scan.birthDate, run.birthDate), "birth date");
    add(differs(scan.sex, run.sex) && bare(scan.sex) != "o" && bare(run.sex) != "o", "sex");
    return reasons.empty() ? reasons
                           : "Scan and angiogram seem to be of different patients (" + reasons +
                                 (count > 1 ? " differ" : " differs") + "). Check that both are the right ones.";
}

std::string findSideMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    const std::string first = bare(scan.laterality), second = bare(run.laterality);
    const bool areOpposite = (first == "l" && second == "r") || (first == "r" && second == "l");
    return areOpposite ? "The scan is of the patient's " + std::string(first == "l" ? "left" : "right") +
                             " side, the angiogram of the other. Check that both are the right ones."
                       : "";
}

std::string findMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    const std::string patient = findPatientMismatch(scan, run), side = findSideMismatch(scan, run);
    return patient.empty() || side.empty() ? patient + side : patient + " " + side;
}

}   // namespace angiopose::core