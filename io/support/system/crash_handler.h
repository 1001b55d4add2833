#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace angiopose::io {

/// The program and libraries as they lie in memory, read from the system while a signal is handled: no memory is asked
/// for, no lock is taken.
class LoadedModules {
public:
    struct Module {
        std::uintptr_t begin = 0;   ///< where the file's first byte lies
        std::uintptr_t end = 0;
        const char* path = nullptr;
    };

    void read();
    const Module* at(std::uintptr_t address) const;   ///< null: in no file

    /// The last part of its path: nothing of whose machine it is.
    static std::string_view nameOf(const Module& module);

private:
    void takeLine(char* line);

    std::array<Module, 512> modules_{};
    std::size_t count_ = 0;
    std::array<char, 65536> paths_{};
    std::size_t used_ = 0;
};

/// The function that an offset in a module lies in, as its symbol table has it (mangled); empty where it has none.
/// Written into `place`.
std::string_view functionAt(const char* modulePath, std::uintptr_t offset, std::array<char, 512>& place);

/// Which program's faults are written down, and where.
struct CrashWriter {
    std::string program;   ///< "angiopose", the beginning of the files' names
    std::string version;
    std::string folder;   ///< made where it is not there
};

/// From now on a fault (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, std::terminate) leaves a file in the folder before it
/// ends the process by the same signal: version, signal, time, thread and stack with module, offset and, where the
/// module has it, the function. No path, no argument, no text of an exception: nothing of who or what was worked on.
/// For the start of a program; nothing under sanitizers, which do the same.
void writeCrashDumps(const CrashWriter& writer);

}   // namespace angiopose::io
