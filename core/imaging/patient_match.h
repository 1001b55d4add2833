#pragma once

#include "core/imaging/angiogram.h"

#include <string>

namespace angiopose::core {

/// What speaks against two images being of the same patient, without naming anybody: differing number, name, birth
/// date or sex, where both give one. Empty when nothing does.
std::string findPatientMismatch(const StudyIdentity& scan, const StudyIdentity& run);

/// The same for the side of a paired body part, left or right.
std::string findSideMismatch(const StudyIdentity& scan, const StudyIdentity& run);

/// Both together.
std::string findMismatch(const StudyIdentity& scan, const StudyIdentity& run);

}   // namespace angiopose::core