#include "io/support/system/crash_handler.h"

#include "io/support/system/signal_text.h"

#include <cxxabi.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string_view>
#include <typeinfo>

namespace angiopose::io {
namespace {

/// Program and libraries as mapped in memory, read from the system inside a signal handler, without allocating memory
/// or taking locks.
class LoadedModules {
public:
    struct Module {
        std::uintptr_t begin = 0;   ///< address at which the first byte of the file is mapped
        std::uintptr_t end = 0;
        const char* path = nullptr;
    };

    void read();
    const Module* at(std::uintptr_t address) const;   ///< returns null if the address is in no module

    /// Returns the file name without its folders, which may identify the user.
    static std::string_view nameOf(const Module& module);

private:
    void takeLine(char* line);

    std::array<Module, 512> modules_{};
    std::size_t count_ = 0;
    std::array<char, 65536> paths_{};
    std::size_t used_ = 0;
};

std::uintptr_t hexadecimalAt(const char*& at)
{
    std::uintptr_t value = 0;
    for (;; ++at) {
        const char c = *at;
        const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) {
            return value;
        }
        value = value * 16 + static_cast<std::uintptr_t>(digit);
    }
}

/// File of a module, mapped while its symbols are searched.
class MappedModule {
public:
    explicit MappedModule(const char* path)
    {
        const int file = ::open(path, O_RDONLY | O_CLOEXEC);
        struct stat status {};
        if (file >= 0 && ::fstat(file, &status) == 0 && status.st_size > 0) {
            size_ = static_cast<std::size_t>(status.st_size);
            void* const mapping = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file, 0);
            bytes_ = mapping == MAP_FAILED ? nullptr : static_cast<const char*>(mapping);
        }
        if (file >= 0) {
            ::close(file);
        }
    }
    ~MappedModule()
    {
        if (bytes_ != nullptr) {
            ::munmap(const_cast<char*>(bytes_), size_);
        }
    }
    MappedModule(const MappedModule&) = delete;
    MappedModule& operator=(const MappedModule&) = delete;

    /// Returns `count` objects of type T at an offset; null if they do not lie completely inside the file.
    template <class T>
    const T* at(std::size_t offset, std::size_t count = 1) const
    {
        const bool isThere = bytes_ != nullptr && offset <= size_ && count <= (size_ - offset) / sizeof(T);
        return isThere ? reinterpret_cast<const T*>(bytes_ + offset) : nullptr;
    }

private:
    const char* bytes_ = nullptr;
    std::size_t size_ = 0;
};

struct SymbolTable {
    const ElfW(Sym) * symbols = nullptr;
    std::size_t count = 0;
    const char* names = nullptr;
    std::size_t nameBytes = 0;
};

SymbolTable tableOf(const MappedModule& file, unsigned type)
{
    const auto* header = file.at<ElfW(Ehdr)>(0);
    const bool isElf = header != nullptr && std::memcmp(header->e_ident, ELFMAG, SELFMAG) == 0;
    const auto* sections = isElf ? file.at<ElfW(Shdr)>(header->e_shoff, header->e_shnum) : nullptr;
    for (std::size_t i = 0; sections != nullptr && i < header->e_shnum; ++i) {
        const auto& section = sections[i];
        if (section.sh_type == type && section.sh_link < header->e_shnum) {
            const auto& names = sections[section.sh_link];
            const std::size_t count = section.sh_size / sizeof(ElfW(Sym));
            return {file.at<ElfW(Sym)>(section.sh_offset, count), count, file.at<char>(names.sh_offset, names.sh_size),
                    names.sh_size};
        }
    }
    return {};
}

const char* functionIn(const SymbolTable& table, std::uintptr_t offset)
{
    for (std::size_t i = 0; table.symbols != nullptr && table.names != nullptr && i < table.count; ++i) {
        const auto& symbol = table.symbols[i];
        const bool isFunction = (symbol.st_info & 0xf) == STT_FUNC && symbol.st_name < table.nameBytes;
        if (isFunction && offset >= symbol.st_value && offset - symbol.st_value < symbol.st_size) {
            return table.names + symbol.st_name;
        }
    }
    return nullptr;
}

void LoadedModules::read()
{
    const int file = ::open("/proc/self/maps", O_RDONLY | O_CLOEXEC);
    std::array<char, 1024> line{};
    std::size_t size = 0;
    for (std::array<char, 4096> piece{}; file >= 0;) {
        const ssize_t got = ::read(file, piece.data(), piece.size());
        if (got <= 0) {
            break;
        }
        for (ssize_t i = 0; i < got; ++i) {
            const char c = piece[static_cast<std::size_t>(i)];
            if (c != '\n') {
                line[size] = c;
                size = std::min(size + 1, line.size() - 1);
                continue;
            }
            line[size] = '\0';
            takeLine(line.data());
            size = 0;
        }
    }
    if (file >= 0) {
        ::close(file);
    }
}

/// Parses one line of /proc/self/maps (start-end perms offset dev inode path); the mappings of a module are adjacent.
void LoadedModules::takeLine(char* line)
{
    const char* path = std::strchr(line, '/');
    const char* at = line;
    const std::uintptr_t begin = hexadecimalAt(at);
    const std::uintptr_t end = *at == '-' ? hexadecimalAt(++at) : 0;
    if (path == nullptr || end == 0) {
        return;
    }
    if (count_ > 0 && std::strcmp(modules_[count_ - 1].path, path) == 0) {
        modules_[count_ - 1].end = end;
        return;
    }
    const std::size_t length = std::strlen(path) + 1;
    if (count_ < modules_.size() && length <= paths_.size() - used_) {
        char* const kept = paths_.data() + used_;
        std::memcpy(kept, path, length);
        used_ += length;
        modules_[count_++] = {begin, end, kept};
    }
}

const LoadedModules::Module* LoadedModules::at(std::uintptr_t address) const
{
    for (std::size_t i = 0; i < count_; ++i) {
        if (address >= modules_[i].begin && address < modules_[i].end) {
            return &modules_[i];
        }
    }
    return nullptr;
}

std::string_view LoadedModules::nameOf(const Module& module)
{
    return std::strrchr(module.path, '/') + 1;
}

/// Returns the mangled name of the function at an offset in a module, from the symbol table; empty if there is none.
/// Writes the name into `place`.
std::string_view functionAt(const char* modulePath, std::uintptr_t offset, std::array<char, 512>& place)
{
    const MappedModule file(modulePath);
    const char* name = functionIn(tableOf(file, SHT_SYMTAB), offset);
    name = name != nullptr ? name : functionIn(tableOf(file, SHT_DYNSYM), offset);
    const std::size_t size = name != nullptr ? ::strnlen(name, place.size()) : 0;
    std::copy_n(name, size, place.begin());
    return {place.data(), size};
}

struct FaultSignal {
    int number;
    std::string_view name;
};

constexpr std::array faultSignals{FaultSignal{SIGSEGV, "SIGSEGV"}, FaultSignal{SIGBUS, "SIGBUS"},
                                  FaultSignal{SIGFPE, "SIGFPE"}, FaultSignal{SIGILL, "SIGILL"},
                                  FaultSignal{SIGABRT, "SIGABRT"}};

/// Everything that the handler needs, prepared while allocating memory is still safe.
struct Preparation {
    std::array<char, 4096> pathBegin{};   ///< path of the dump, part before the time
    std::array<char, 32> process{};   ///< path of the dump, part after the time
    std::array<char, 128> program{};
    std::array<char, 65536> ownStack{};   ///< alternate signal stack, because the normal stack may have overflowed
    std::array<void*, 128> frames{};
    LoadedModules modules;
    std::atomic<const char*> endedBy{nullptr};   ///< type of the uncaught exception
};

Preparation& prepared()
{
    static Preparation all;
    return all;
}

std::atomic_flag isBeingWritten = ATOMIC_FLAG_INIT;

template <std::size_t Size>
void put(const std::string& text, std::array<char, Size>& place)
{
    place[text.copy(place.data(), Size - 1)] = '\0';
}

int openDump(const SignalTime& time)
{
    static std::array<char, 4096 + 64> path{};
    const Preparation& known = prepared();
    std::size_t size = 0;
    for (const char* part :
         {known.pathBegin.data(), static_cast<const char*>(time.text.data()), known.process.data()}) {
        for (; *part != '\0' && size + 1 < path.size(); ++part) {
            if (*part != ':') {   // some file systems do not permit colons in names
                path[size++] = *part;
            }
        }
    }
    path[size] = '\0';
    return ::open(path.data(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
}

void writeHead(SignalText& out, int signal, const siginfo_t& about, const SignalTime& time)
{
    std::string_view name = "signal";
    for (const FaultSignal& known : faultSignals) {
        name = known.number == signal ? known.name : name;
    }
    out << prepared().program.data() << "\nsignal: " << name << " (";
    out.decimal(static_cast<unsigned>(signal)) << "), code ";
    const bool isByKernel = about.si_code > 0;
    out.decimal(static_cast<unsigned>(isByKernel ? about.si_code : 0)) << (isByKernel ? "" : ", sent by a process");
    if (isByKernel && signal != SIGABRT) {
        out << ", at ";
        out.hexadecimal(reinterpret_cast<std::uintptr_t>(about.si_addr));
    }
    if (const char* type = prepared().endedBy.load()) {
        out << "\nstd::terminate: " << type;
    }
    std::array<char, 17> thread{};
    ::prctl(PR_GET_NAME, thread.data(), 0, 0, 0);
    out << "\ntime: " << time.text.data() << "\nthread: " << (::syscall(SYS_gettid) == ::getpid() ? "main, " : "")
        << thread.data() << "\n";
}

std::uintptr_t hostAndPort(int frame)
{
    const auto address = reinterpret_cast<std::uintptr_t>(prepared().frames[static_cast<std::size_t>(frame)]);
    return frame == 0 ? address : address - 1;   // address of the call rather than the return address
}

void writeFrames(SignalText& out, int count)
{
    out << "stack:\n";
    for (int i = 0; i < count; ++i) {
        const LoadedModules::Module* module = prepared().modules.at(hostAndPort(i));
        out.decimal(static_cast<unsigned>(i), 2) << " ";
        if (module != nullptr) {
            out << LoadedModules::nameOf(*module) << "+";
            out.hexadecimal(hostAndPort(i) - module->begin) << "\n";
        } else {
            out.hexadecimal(hostAndPort(i)) << "\n";
        }
    }
    out.flush();
}

/// Writes the function names only after the stack is on disk, because reading the module files may itself crash.
void writeFunctions(SignalText& out, int count)
{
    static std::array<char, 512> place{};
    out << "functions:\n";
    for (int i = 0; i < count; ++i) {
        const LoadedModules::Module* module = prepared().modules.at(hostAndPort(i));
        const std::string_view function =
            module != nullptr ? functionAt(module->path, hostAndPort(i) - module->begin, place) : std::string_view();
        if (!function.empty()) {
            out.decimal(static_cast<unsigned>(i), 2);
            out << " " << function << "\n";
            out.flush();
        }
    }
}

void writeDump(int signal, const siginfo_t& about)
{
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    const SignalTime time(now.tv_sec);
    const int file = openDump(time);
    if (file < 0) {
        return;
    }
    SignalText out(file);
    writeHead(out, signal, about, time);
    out.flush();
    Preparation& known = prepared();
    known.modules.read();
    const int count = ::backtrace(known.frames.data(), static_cast<int>(known.frames.size()));
    writeFrames(out, count);
    writeFunctions(out, count);
    out << "end\n";
    out.flush();
    ::fsync(file);
    ::close(file);
}

extern "C" void onFault(int signal, siginfo_t* about, void*)
{
    if (isBeingWritten.test_and_set()) {
        for (;;) {
            ::pause();   // another thread is writing its own crash and will terminate the process
        }
    }
    writeDump(signal, *about);
    std::signal(signal, SIG_DFL);
    std::raise(signal);   // delivered when the handler returns
}

[[noreturn]] void onTerminate()
{
    const std::type_info* type = abi::__cxa_current_exception_type();
    prepared().endedBy = type != nullptr ? type->name() : "without an exception";
    std::abort();
}

constexpr bool areSanitizersThere =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

void prepare(const CrashDumpSettings& writer)
{
    std::error_code failed;
    std::filesystem::create_directories(writer.folder, failed);
    ::chmod(writer.folder.c_str(), 0700);
    Preparation& known = prepared();
    put(writer.folder + '/' + writer.program + '-', known.pathBegin);
    put('-' + std::to_string(::getpid()) + ".txt", known.process);
    put("program: " + writer.program + ' ' + writer.version, known.program);
    (void)::backtrace(known.frames.data(), 1);   // loads the required libraries now, because loading allocates memory
}

}   // namespace

void installCrashHandler(const CrashDumpSettings& writer)
{
    if (areSanitizersThere || writer.folder.size() > 3900) {
        return;
    }
    prepare(writer);
    stack_t stack{};
    stack.ss_sp = prepared().ownStack.data();
    stack.ss_size = prepared().ownStack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_sigaction = onFault;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (const FaultSignal& fault : faultSignals) {
        ::sigaction(fault.number, &action, nullptr);
    }
    std::set_terminate(onTerminate);
}

}   // namespace angiopose::io
