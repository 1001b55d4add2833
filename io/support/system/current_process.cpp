#include "io/support/system/current_process.h"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>

namespace angiopose::io {

std::filesystem::path currentBinaryPath()
{
    namespace fs = std::filesystem;
    Dl_info info{};
    link_map* map = nullptr;
    const bool isFound = ::dladdr1(reinterpret_cast<const void*>(&currentBinaryPath), &info,
                                   reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
    const bool isLibrary =
        isFound && map != nullptr && map->l_name[0] != '\0';   // the name is empty for the main program
    std::error_code ignored;
    return isLibrary ? fs::canonical(map->l_name, ignored) : fs::read_symlink("/proc/self/exe", ignored);
}

bool isExecutable(const std::filesystem::path& file)
{
    return ::access(file.c_str(), X_OK) == 0;
}

double physicalMemoryBytes()
{
    return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

int currentProcessId()
{
    return ::getpid();
}

bool isProcessRunning(int process)
{
    if (::kill(process, 0) != 0 && errno == ESRCH) {
        return false;
    }
    // A process that has ended stays listed as a zombie until its parent waits for it, so check its state.
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    const std::string stat{std::istreambuf_iterator<char>(file), {}};
    const std::size_t state = stat.rfind(") ");
    return state == std::string::npos || stat.substr(state + 2, 1).find_first_of("ZX") == std::string::npos;
}

std::string hostName()
{
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 && name[0] != '\0' ? name.data() : "localhost";
}

bool isTerminal(std::FILE* stream)
{
    return ::isatty(::fileno(stream)) == 1;
}

}   // namespace angiopose::io
