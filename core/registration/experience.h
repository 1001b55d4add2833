#pragma once

#include "core/registration/problem/registration_result.h"

namespace angiopose::core {

/// Lets a result of the default method from one view say how likely its overlay lies within 2 mm of the vessels, by
/// experience with such fits, and trust follow where that is clear (ALGORITHMS §6.21): a fit that is all but sure is
/// trusted though little agrees or little is filled, one that often fails is not. Of a fit that other signs
/// speak against, a high probability is not stated.
void heedExperience(RegistrationResult& result);

}   // namespace angiopose::core
