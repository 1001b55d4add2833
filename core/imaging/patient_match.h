#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"

#include <optional>

namespace angiopose::core {

/// Types of the two compared images.
enum class ComparedImages { ScanAndRun, TwoRuns };

/// Reports contradictory patient data of two images without any identity: different patient ID, name, birth date or
/// sex, if both images contain the value.
std::optional<Message> findPatientMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                           ComparedImages compared = ComparedImages::ScanAndRun);

/// Does the same for the laterality of a paired body part.
std::optional<Message> findLateralityMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                              ComparedImages compared = ComparedImages::ScanAndRun);

/// Does the same for two runs used as simultaneous views: their accession numbers must be equal if both have one. A
/// scan has its own accession number and is not compared.
std::optional<Message> findExaminationMismatch(const StudyIdentity& one, const StudyIdentity& other);

/// Returns all mismatches of these kinds.
Messages findMismatch(const StudyIdentity& one, const StudyIdentity& other,
                      ComparedImages compared = ComparedImages::ScanAndRun);

}   // namespace angiopose::core
