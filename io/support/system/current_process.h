#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace angiopose::io {

/// Returns the path of the program or shared library that contains this code; empty if the system does not provide it.
std::filesystem::path currentBinaryPath();

bool isExecutable(const std::filesystem::path& file);

/// Returns the total memory of the computer, bytes.
double physicalMemoryBytes();

int currentProcessId();

/// Returns whether a process is running, including processes of other users.
bool isProcessRunning(int process);

/// Returns the host name of the computer; "localhost" if there is none.
std::string hostName();

/// Returns whether the stream writes to a terminal.
bool isTerminal(std::FILE* stream);

}   // namespace angiopose::io
