#include "io/support/system/machine_info.h"

#include <pwd.h>
#include <sys/utsname.h>
#include <unistd.h>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace angiopose::io {
namespace {

/// Returns the text after the first `=` or `:` of the line that starts with `key`, without quotes.
std::string valueIn(const char* path, const std::string& key)
{
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const std::size_t sign = line.find_first_of("=:");
        if (!line.starts_with(key) || sign == std::string::npos) {
            continue;
        }
        const std::size_t begin = line.find_first_not_of(" \t\"", sign + 1);
        const std::size_t end = line.find_last_not_of(" \t\"");
        return begin == std::string::npos ? std::string() : line.substr(begin, end - begin + 1);
    }
    return {};
}

const passwd* account()
{
    return ::getpwuid(::geteuid());
}

}   // namespace

MachineInfo machineInfo()
{
    MachineInfo facts;
    facts.system = valueIn("/etc/os-release", "PRETTY_NAME");
    utsname kernel{};
    if (::uname(&kernel) == 0) {
        facts.system += (facts.system.empty() ? "" : ", ") + std::string(kernel.sysname) + " " + kernel.release + " " +
                        kernel.machine;
    }
    facts.processor = valueIn("/proc/cpuinfo", "model name");
    facts.cores = static_cast<int>(std::thread::hardware_concurrency());
    return facts;
}

std::string accountName()
{
    const passwd* known = account();
    return known != nullptr && known->pw_name != nullptr ? known->pw_name : "";
}

std::string accountFullName()
{
    const passwd* known = account();
    const std::string all = known != nullptr && known->pw_gecos != nullptr ? known->pw_gecos : "";
    return all.substr(0, all.find(','));
}

std::string homeFolder()
{
    const char* home = std::getenv("HOME");
    const passwd* known = home == nullptr ? account() : nullptr;
    return home != nullptr ? home : known != nullptr && known->pw_dir != nullptr ? known->pw_dir : "";
}

}   // namespace angiopose::io
