#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace angiopose::io {

/// Returns the path of the program or shared library that contains this code; empty if the system does not provide it.
std::filesystem::path ownBinary();

bool isExecutable(const std::filesystem::path& file);

/// Returns the total memory of the computer, bytes.
double memoryBytes();

int ownProcessId();

/// Whether a process is running, including processes of other users.
bool isAlive(int process);

/// Returns the host name of the computer; "localhost" if there is none.
std::string machineName();

/// Whether the stream writes to a terminal.
bool isTerminal(std::FILE* stream);

}   // namespace angiopose::io
