#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace angiopose::app {

/// Adds `--frame`, which counts from 1 as in the window and in DICOM.
inline CLI::Option* addFrameOption(CLI::App& command, std::optional<int>& frame, const std::string& help)
{
    return command.add_option_function<int>(
        "--frame", [&frame](int number) { frame = std::max(number, 0) - 1; }, help);
}

}   // namespace angiopose::app
