#pragma once

#include "core/registration/options/option_fields.h"

// Option table in parts, one per family of methods.
namespace angiopose::core::option_fields {

/// Options of all methods or several of them.
std::vector<OptionField> commonFields();

/// Options of the DynaWeightPnP methods and of those built like them.
std::vector<OptionField> seedFields();

/// Options of matching and the alternating search.
std::vector<OptionField> alternatingFields();

/// Options of AngioPose's own solver.
std::vector<OptionField> solverFields();

/// Options of the camera geometry and its errors.
std::vector<OptionField> geometryFields();

/// Options of iterated closest points.
std::vector<OptionField> icpFields();

/// Options of gradient ascent on kernels.
std::vector<OptionField> nicpFields();

/// Options of intensity-based methods.
std::vector<OptionField> imageFields();

/// Options of mixtures and global searches.
std::vector<OptionField> globalFields();

/// Options of the correlation flow.
std::vector<OptionField> flowFields();

/// Options of graph-based branch matching.
std::vector<OptionField> graphFields();

/// Options of registering a single wire or catheter.
std::vector<OptionField> wireFields();

/// Options of random numbers.
std::vector<OptionField> closingFields();

}   // namespace angiopose::core::option_fields
