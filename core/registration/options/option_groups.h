#pragma once

#include "core/registration/options/option_fields.h"

// The table of options in parts, one per family of methods.
namespace angiopose::core::option_fields {

/// What every method or several read.
std::vector<OptionField> commonFields();

/// The seed's methods, and what those built like them share.
std::vector<OptionField> seedFields();

/// Matching and the alternating search.
std::vector<OptionField> alternatingFields();

/// Our own solver.
std::vector<OptionField> solverFields();

/// What is known of the camera.
std::vector<OptionField> geometryFields();

/// Iterated closest points.
std::vector<OptionField> icpFields();

/// Gradient ascent on kernels.
std::vector<OptionField> nicpFields();

/// Methods that read the image.
std::vector<OptionField> imageFields();

/// Mixtures and searches.
std::vector<OptionField> globalFields();

/// Flow of a correlation.
std::vector<OptionField> flowFields();

/// Branches of tree and image as graphs.
std::vector<OptionField> graphFields();

/// A wire or catheter alone.
std::vector<OptionField> wireFields();

/// Chance.
std::vector<OptionField> closingFields();

}   // namespace angiopose::core::option_fields
