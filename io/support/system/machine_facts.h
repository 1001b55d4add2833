#pragma once

#include <string>

namespace angiopose::io {

/// Machine data for crash reports; texts are empty if the system does not provide them.
struct MachineFacts {
    std::string system;   ///< "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64"
    std::string processor;
    int cores = 0;
};
MachineFacts machineFacts();

/// Returns the account name of the user who runs this process.
std::string accountName();
std::string accountFullName();
std::string homeFolder();

}   // namespace angiopose::io
