#pragma once

#include "io/pose/named_matrices.h"

namespace angiopose::io {

/// Numbers and matrices at the top of YAML: those of OpenCV's FileStorage, and plain or nested lists.
NamedMatrices matricesOfYaml(std::string_view text);

/// The same of OpenCV's XML.
NamedMatrices matricesOfXml(std::string_view text);

/// K, R, t and the image size as OpenCV's FileStorage reads them. fx < 0 where the image is as seen from the detector.
std::string openCvYaml(const core::Sight& sight);
std::string openCvXml(const core::Sight& sight);
std::string openCvJson(const core::Sight& sight);

/// P as three rows of four numbers.
std::string projectionText(const core::Sight& sight);

/// All numbers of a text, between blanks, commas, semicolons and brackets; `#` begins a comment. Empty where there is
/// anything else.
std::vector<double> numbersOfText(std::string_view text);

}   // namespace angiopose::io
