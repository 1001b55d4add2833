#pragma once

#include <string>

namespace angiopose::io {

/// What a report of a fault says about the machine; texts are empty where the system does not tell.
struct MachineFacts {
    std::string system;   ///< "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64"
    std::string processor;
    int cores = 0;
};
MachineFacts machineFacts();

/// Of who runs this process.
std::string accountName();
std::string accountFullName();
std::string homeFolder();

}   // namespace angiopose::io
