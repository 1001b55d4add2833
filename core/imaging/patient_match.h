#pragma once

#include "core/imaging/angiogram.h"
#include "core/support/message.h"

#include <optional>

namespace angiopose::core {

/// What speaks against two images being of the same patient, without naming anybody: differing number, name, birth
/// date or sex, where both give one.
std::optional<Message> findPatientMismatch(const StudyIdentity& scan, const StudyIdentity& run);

/// The same for the side of a paired body part, left or right.
std::optional<Message> findSideMismatch(const StudyIdentity& scan, const StudyIdentity& run);

/// Both.
Messages findMismatch(const StudyIdentity& scan, const StudyIdentity& run);

}   // namespace angiopose::core