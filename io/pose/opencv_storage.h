#pragma once

#include "io/pose/named_matrices.h"

namespace angiopose::io {

/// Parses the top-level numbers and matrices of a YAML file: those of OpenCV's FileStorage, and plain or nested lists.
NamedMatrices parseYamlMatrices(std::string_view text);

/// Parses the numbers and matrices of OpenCV's XML format.
NamedMatrices parseXmlMatrices(std::string_view text);

/// Returns K, R, t and the image size in the YAML format of OpenCV's FileStorage; fx < 0 if the image is viewed from
/// the detector side.
std::string openCvYaml(const core::PosedCamera& posedCamera);
std::string openCvXml(const core::PosedCamera& posedCamera);
std::string openCvJson(const core::PosedCamera& posedCamera);

/// Returns the projection matrix P as three rows of four numbers.
std::string projectionText(const core::PosedCamera& posedCamera);

/// Returns all numbers of a text; blanks, commas, semicolons and brackets separate them, and `#` starts a comment.
/// Empty if the text contains anything else.
std::vector<double> parseNumbers(std::string_view text);

}   // namespace angiopose::io
