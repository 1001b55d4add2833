#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace angiopose::io {

/// Returns the path of the program or shared library that contains this code; empty if the system does not provide it.
std::filesystem::path ownBinary();

bool isExecutable(const std::filesystem::path& file);

/// Returns the total memory of the machine, bytes.
double memoryBytes();

int ownProcessId();

/// Returns whether a process is running, including those of other users.
bool isAlive(int process);

/// Returns the host name; "localhost" if it has none.
std::string machineName();

/// Returns whether the stream writes to a terminal.
bool isTerminal(std::FILE* stream);

}   // namespace angiopose::io
