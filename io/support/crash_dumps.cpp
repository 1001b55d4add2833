#include "io/support/crash_dumps.h"

#include "io/support/system/crash_handler.h"

#include <cxxabi.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t keptDumps = 10;

/// Returns whether a dump is of a program: for `angiopose`, "angiopose-20260131…", but not "angiopose-cli-20260131…".
bool isDumpOf(const std::string& name, const std::string& program)
{
    if (!name.ends_with(".txt") || !name.starts_with(program.empty() ? "angiopose" : program + "-")) {
        return false;
    }
    const char next = program.empty() ? '0' : name[program.size() + 1];
    return next >= '0' && next <= '9';
}

/// Returns the part of the file name after the program name, "2026-01-31T080509Z-1234.txt".
std::string timeIn(const fs::path& dump)
{
    const std::string name = dump.filename().string();
    const std::size_t digit = name.find_first_of("0123456789");
    return digit == std::string::npos ? name : name.substr(digit);
}

std::string readable(const std::string& line)
{
    const std::size_t name = line.find(" _Z");
    if (name == std::string::npos) {
        return line;
    }
    int failed = 0;
    const std::unique_ptr<char, decltype(&std::free)> plain(
        abi::__cxa_demangle(line.c_str() + name + 1, nullptr, nullptr, &failed), &std::free);
    return failed == 0 ? line.substr(0, name + 1) + plain.get() : line;
}

}   // namespace

namespace fs = std::filesystem;

fs::path stateFolder()
{
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    const fs::path base =
        state != nullptr && *state == '/' ? fs::path(state) : fs::path(home != nullptr ? home : ".") / ".local/state";
    return base / "angiopose";
}

fs::path crashFolder()
{
    return stateFolder() / "crashes";
}

void enableCrashDumps(const std::string& program)
{
    installCrashHandler({program, ANGIOPOSE_VERSION, crashFolder().string()});
    const std::vector<fs::path> dumps = crashDumps();
    for (std::size_t i = keptDumps; i < dumps.size(); ++i) {
        std::error_code ignored;
        fs::remove(dumps[i], ignored);
    }
}

std::vector<fs::path> crashDumps(const std::string& program)
{
    std::vector<fs::path> dumps;
    std::error_code failed;
    for (fs::directory_iterator each(crashFolder(), failed), end; !failed && each != end; each.increment(failed)) {
        if (isDumpOf(each->path().filename().string(), program)) {
            dumps.push_back(each->path());
        }
    }
    std::ranges::sort(dumps, std::greater{}, timeIn);
    return dumps;
}

std::string demangleDump(const fs::path& dump)
{
    std::ifstream file(dump);
    std::string text;
    for (std::string line; std::getline(file, line);) {
        text += readable(line) + '\n';
    }
    return text;
}

}   // namespace angiopose::io
