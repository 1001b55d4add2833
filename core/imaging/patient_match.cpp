#include "core/imaging/patient_match.h"

#include "core/messages/messages.h"

#include <algorithm>
#include <cctype>

namespace angiopose::core {
namespace {

/// Returns only the letters and digits, in lower case; "DOE^JOHN " and "Doe^John" then compare equal.
std::string normalizedText(const std::string& text)
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
    const std::string first = normalizedText(a), second = normalizedText(b);
    return !first.empty() && !second.empty() && first != second;
}

}   // namespace

std::optional<Message> findPatientMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                           ComparedImages compared)
{
    Messages reasons;
    const auto add = [&reasons](bool isDifferent, const auto& what) {
        if (isDifferent) {
            reasons.push_back(what());
        }
    };
    add(differs(one.patientId, other.patientId), messages::patientNumber);
    add(differs(one.patientName, other.patientName), messages::patientName);
    add(differs(one.birthDate, other.birthDate), messages::patientBirthDate);
    add(differs(one.sex, other.sex) && normalizedText(one.sex) != "o" && normalizedText(other.sex) != "o",
        messages::patientSex);
    if (reasons.empty()) {
        return std::nullopt;
    }
    if (compared == ComparedImages::TwoRuns) {
        return reasons.size() > 1 ? messages::patientOfRunsDiffersInSeveral(reasons)
                                  : messages::patientOfRunsDiffers(reasons);
    }
    return reasons.size() > 1 ? messages::patientDiffersInSeveral(reasons) : messages::patientDiffers(reasons);
}

std::optional<Message> findLateralityMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                              ComparedImages compared)
{
    const std::string first = normalizedText(one.laterality), second = normalizedText(other.laterality);
    const bool areOpposite = (first == "l" && second == "r") || (first == "r" && second == "l");
    if (!areOpposite) {
        return std::nullopt;
    }
    if (compared == ComparedImages::TwoRuns) {
        return messages::patientSideOfRunsDiffers();
    }
    return messages::patientSideDiffers(first == "l" ? messages::sideLeft() : messages::sideRight());
}

std::optional<Message> findExaminationMismatch(const StudyIdentity& one, const StudyIdentity& other)
{
    return differs(one.accessionNumber, other.accessionNumber) ? std::optional(messages::examinationOfRunsDiffers())
                                                               : std::nullopt;
}

Messages findMismatch(const StudyIdentity& one, const StudyIdentity& other, ComparedImages compared)
{
    Messages found;
    for (const auto& mismatch :
         {findPatientMismatch(one, other, compared), findLateralityMismatch(one, other, compared)}) {
        if (mismatch) {
            found.push_back(*mismatch);
        }
    }
    if (const auto mismatch = findExaminationMismatch(one, other); mismatch && compared == ComparedImages::TwoRuns) {
        found.push_back(*mismatch);
    }
    return found;
}

}   // namespace angiopose::core
