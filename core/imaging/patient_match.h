#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"

#include <optional>

namespace angiopose::core {

/// Types of the two compared images.
enum class ComparedImages { ScanAndRun, TwoRuns };

/// Returns a message about contradictory patient data of two images, without any identity: different patient ID, name,
/// birth date or sex, if both images contain the value.
std::optional<Message> findPatientMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                           ComparedImages compared = ComparedImages::ScanAndRun);

/// Returns a message about different lateralities of a paired body part.
std::optional<Message> findLateralityMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                              ComparedImages compared = ComparedImages::ScanAndRun);

/// Returns a message if two runs used as simultaneous views have different accession numbers. A scan has its own
/// accession number and is not compared.
std::optional<Message> findExaminationMismatch(const StudyIdentity& one, const StudyIdentity& other);

/// Returns messages about all mismatches of these kinds.
Messages findMismatch(const StudyIdentity& one, const StudyIdentity& other,
                      ComparedImages compared = ComparedImages::ScanAndRun);

}   // namespace angiopose::core
