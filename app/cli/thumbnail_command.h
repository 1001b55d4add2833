#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `thumbnail`, which file managers call; it sets `exitCode`.
void addThumbnail(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
