#pragma once

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace angiopose::app {

/// Pose conventions of other programs (FORMATS §3.4).
enum class PoseConvention { AngioPose, OpenCv, Xreg, DiffDrr };

struct ExchangeArguments {
    PoseConvention from = PoseConvention::AngioPose;
    PoseConvention to = PoseConvention::AngioPose;
    std::string cameraPath;   ///< case, pose with its camera, or DiffDRR detector; if empty, the camera of the input
    std::string volumePath;   ///< path of the volume whose center is the DiffDRR origin; may be empty
    double sourceToDetectorMm = 0.0;   ///< if 0, that of the case, or 1000 mm
};

std::shared_ptr<ExchangeArguments> addExchangeOptions(CLI::App& command);

/// Returns whether the conversion needs `runExchangeConversion`: true if it involves a pose with its camera, the pose
/// convention of another program, or points.
bool isExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange);
int runExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange);

}   // namespace angiopose::app
