#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"

#include <optional>

namespace angiopose::core {

/// What the two images are that are compared.
enum class Compared { ScanAndRun, TwoRuns };

/// What speaks against two images being of the same patient, without naming anybody: differing number, name, birth
/// date or sex, where both give one.
std::optional<Message> findPatientMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                           Compared compared = Compared::ScanAndRun);

/// The same for the side of a paired body part, left or right.
std::optional<Message> findSideMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                        Compared compared = Compared::ScanAndRun);

/// The same for two runs that are taken for views of one moment: they are of one examination where both give an
/// accession number. A scan has its own.
std::optional<Message> findExaminationMismatch(const StudyIdentity& one, const StudyIdentity& other);

/// All of them.
Messages findMismatch(const StudyIdentity& one, const StudyIdentity& other, Compared compared = Compared::ScanAndRun);

}   // namespace angiopose::core