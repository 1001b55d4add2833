#pragma once

#include <CLI/CLI.hpp>

namespace angiopose::app {

/// Adds `thumbnail`, which file managers run; it sets `exitCode` when it does.
void addThumbnail(CLI::App& app, int& exitCode);

}   // namespace angiopose::app
