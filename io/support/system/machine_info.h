#pragma once

#include <string>

namespace angiopose::io {

/// Properties of the computer, for crash reports; strings are empty if the system does not provide the value.
struct MachineInfo {
    std::string system;   ///< for example "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64"
    std::string processor;
    int cores = 0;
};
MachineInfo machineInfo();

/// Returns the account name of the user running this process.
std::string accountName();
std::string accountFullName();
std::string homeFolder();

}   // namespace angiopose::io
