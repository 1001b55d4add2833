#pragma once

#include "core/imaging/angiogram.h"

#include <string>

namespace core {

/// What speaks against two images being of the same patient, without naming anybody: differing number, name or birth
/// date, where both give one. Empty when nothing does.
std::string findPatientMismatch(const StudyIdentity& scan, const StudyIdentity& run);

}   // namespace core
