#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

void addSupportBundle(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
