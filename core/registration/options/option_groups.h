#pragma once

#include "core/registration/options/option_fields.h"

// Parts of the option table, one per family of methods.
namespace angiopose::core::option_fields {

/// Options shared by all or several methods.
std::vector<OptionField> commonFields();

/// Options of the DynaWeightPnP methods and their derivatives.
std::vector<OptionField> seedFields();

/// Options of point matching and of the alternating search.
std::vector<OptionField> alternatingFields();

/// Options of AngioPose's own solver.
std::vector<OptionField> solverFields();

/// Options of the camera geometry and its uncertainty.
std::vector<OptionField> geometryFields();

/// Options of iterative closest point (ICP).
std::vector<OptionField> icpFields();

/// Options of gradient ascent on kernels.
std::vector<OptionField> nicpFields();

/// Options of intensity-based methods.
std::vector<OptionField> imageFields();

/// Options of Gaussian mixtures and global searches.
std::vector<OptionField> globalFields();

/// Options of the correlation flow.
std::vector<OptionField> flowFields();

/// Options of graph-based branch matching.
std::vector<OptionField> graphFields();

/// Options of registration to a single guidewire or catheter.
std::vector<OptionField> wireFields();

/// Options of the random number generator, the last rows of the table.
std::vector<OptionField> randomSeedFields();

}   // namespace angiopose::core::option_fields
