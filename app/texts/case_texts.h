#pragma once

#include "core/registration_case.h"
#include "ui/scenes/render_offscreen.h"

#include <string>

namespace angiopose::app {

enum class Identity { Shown, Hidden };

/// The words that every picture of the program carries.
inline constexpr const char* notForClinicalUse = "Not for clinical use";

/// "header", "derived", "user", "assumed" or "missing".
std::string originText(core::Origin origin);

/// Corner texts where readers of other viewers look for them: patient and study on top, geometry with its basis at the
/// bottom right.
/// The bottom left is the caller's: frame, window and zoom belong to the view.
ui::CornerTexts cornerTexts(const core::RegistrationCase& registrationCase, Identity identity);

/// "0.391 mm/px detector (header)", with the scale at the vessel where the depth is known.
std::string pixelScaleText(const core::RegistrationCase& registrationCase);

}   // namespace angiopose::app