#pragma once

#include "app/cli/commands.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace angiopose::app {

/// How other programs mean a pose (FORMATS §3.4).
enum class PoseConvention { AngioPose, OpenCv, Xreg, DiffDrr };

struct ExchangeArguments {
    PoseConvention from = PoseConvention::AngioPose;
    PoseConvention to = PoseConvention::AngioPose;
    std::string cameraPath;   ///< a case, or a pose with its camera; of DiffDRR its detector. Empty: the input's own
    std::string volumePath;   ///< whose middle DiffDRR has in its origin; empty: none
    double sourceToDetectorMm = 0.0;   ///< 0: the case's, or 1000
};

std::shared_ptr<ExchangeArguments> addExchangeOptions(CLI::App& command);

/// Whether a pose is to be written with its camera or by another convention, or points: not what `runConvert` does.
bool isExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange);
int runExchangeConversion(const ConvertArguments& arguments, const ExchangeArguments& exchange);

}   // namespace angiopose::app
