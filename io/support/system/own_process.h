#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>

namespace angiopose::io {

/// The program or the shared library that this code is part of; empty where the system does not tell.
std::filesystem::path ownBinary();

bool isExecutable(const std::filesystem::path& file);

/// Of the whole machine, bytes.
double memoryBytes();

int ownProcessId();

/// Also of a process of somebody else.
bool isAlive(int process);

/// As the network knows it; "localhost" where it has no name.
std::string machineName();

/// Whether a person watches what is written there.
bool isTerminal(std::FILE* stream);

}   // namespace angiopose::io
