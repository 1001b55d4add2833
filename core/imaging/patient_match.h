#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"

#include <optional>

namespace angiopose::core {

/// Types of the two compared images.
enum class Compared { ScanAndRun, TwoRuns };

/// Reports a contradiction between the patients of two images without naming anyone: different number, name, birth date
/// or sex, if both give one.
std::optional<Message> findPatientMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                           Compared compared = Compared::ScanAndRun);

/// Same for the side of a paired body part, left or right.
std::optional<Message> findSideMismatch(const StudyIdentity& one, const StudyIdentity& other,
                                        Compared compared = Compared::ScanAndRun);

/// Same for two runs used as simultaneous views: they must come from one examination if both give an accession number.
/// A scan has its own.
std::optional<Message> findExaminationMismatch(const StudyIdentity& one, const StudyIdentity& other);

/// Returns all of these mismatches.
Messages findMismatch(const StudyIdentity& one, const StudyIdentity& other, Compared compared = Compared::ScanAndRun);

}   // namespace angiopose::core