#pragma once

#include "io/case/case_document.h"

#include <string>

namespace angiopose::io {

/// The values of the JSON under `geometry`, each with its origin, and `geometry.camera` into the case; what makes no
/// sense into the problems. The schema has been checked.
void readGeometry(const std::string& json, CaseDocument& document);

}   // namespace angiopose::io