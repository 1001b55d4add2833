#include "core/imaging/patient_match.h"

#include "core/messages/says.h"

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

std::optional<Message> findPatientMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    Messages reasons;
    const auto add = [&reasons](bool isDifferent, const auto& what) {
        if (isDifferent) {
            reasons.push_back(what());
        }
    };
    add(differs(scan.patientId, run.patientId), says::patientNumber);
    add(differs(scan.patientName, run.patientName), says::patientName);
    add(differs(scan.birthDate, run.birthDate), says::patientBirthDate);
    add(differs(scan.sex, run.sex) && bare(scan.sex) != "o" && bare(run.sex) != "o", says::patientSex);
    if (reasons.empty()) {
        return std::nullopt;
    }
    return reasons.size() > 1 ? says::patientDiffersInSeveral(reasons) : says::patientDiffers(reasons);
}

std::optional<Message> findSideMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    const std::string first = bare(scan.laterality), second = bare(run.laterality);
    const bool areOpposite = (first == "l" && second == "r") || (first == "r" && second == "l");
    if (!areOpposite) {
        return std::nullopt;
    }
    return says::patientSideDiffers(first == "l" ? says::sideLeft() : says::sideRight());
}

Messages findMismatch(const StudyIdentity& scan, const StudyIdentity& run)
{
    Messages found;
    for (const auto& mismatch : {findPatientMismatch(scan, run), findSideMismatch(scan, run)}) {
        if (mismatch) {
            found.push_back(*mismatch);
        }
    }
    return found;
}

}   // namespace angiopose::core
