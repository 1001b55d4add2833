#include "io/support/system/crash_handler.h"

#include "io/support/system/loaded_modules.h"
#include "io/support/system/signal_text.h"

#include <cxxabi.h>
#include <execinfo.h>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <filesystem>
#include <typeinfo>

namespace angiopose::io {
namespace {

struct FaultSignal {
    int number;
    std::string_view name;
};

constexpr std::array faultSignals{FaultSignal{SIGSEGV, "SIGSEGV"}, FaultSignal{SIGBUS, "SIGBUS"},
                                  FaultSignal{SIGFPE, "SIGFPE"}, FaultSignal{SIGILL, "SIGILL"},
                                  FaultSignal{SIGABRT, "SIGABRT"}};

/// All that the handler needs, made while memory could be asked for.
struct Preparation {
    std::array<char, 4096> pathBegin{};   ///< up to the time
    std::array<char, 32> process{};   ///< what follows the time
    std::array<char, 128> program{};
    std::array<char, 65536> ownStack{};   ///< the usual one may be what is full
    std::array<void*, 128> frames{};
    LoadedModules modules;
    std::atomic<const char*> endedBy{nullptr};   ///< type of the exception that nobody caught
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
            if (*part != ':') {   // some drives know no names with it
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

std::uintptr_t addressOf(int frame)
{
    const auto address = reinterpret_cast<std::uintptr_t>(prepared().frames[static_cast<std::size_t>(frame)]);
    return frame == 0 ? address : address - 1;   // the call, not what comes after it
}

void writeFrames(SignalText& out, int count)
{
    out << "stack:\n";
    for (int i = 0; i < count; ++i) {
        const LoadedModules::Module* module = prepared().modules.at(addressOf(i));
        out.decimal(static_cast<unsigned>(i), 2) << " ";
        if (module != nullptr) {
            out << LoadedModules::nameOf(*module) << "+";
            out.hexadecimal(addressOf(i) - module->begin) << "\n";
        } else {
            out.hexadecimal(addressOf(i)) << "\n";
        }
    }
    out.flush();
}

/// After the stack is on the disk: looking into files may be what fails.
void writeFunctions(SignalText& out, int count)
{
    static std::array<char, 512> place{};
    out << "functions:\n";
    for (int i = 0; i < count; ++i) {
        const LoadedModules::Module* module = prepared().modules.at(addressOf(i));
        const std::string_view function =
            module != nullptr ? functionAt(module->path, addressOf(i) - module->begin, place) : std::string_view();
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
            ::pause();   // another thread's fault is being written, and ends the process
        }
    }
    writeDump(signal, *about);
    std::signal(signal, SIG_DFL);
    std::raise(signal);   // comes when this returns
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

void prepare(const CrashWriter& writer)
{
    std::error_code failed;
    std::filesystem::create_directories(writer.folder, failed);
    ::chmod(writer.folder.c_str(), 0700);
    Preparation& known = prepared();
    put(writer.folder + '/' + writer.program + '-', known.pathBegin);
    put('-' + std::to_string(::getpid()) + ".txt", known.process);
    put("program: " + writer.program + ' ' + writer.version, known.program);
    (void)::backtrace(known.frames.data(), 1);   // loads what it needs, which takes memory
}

}   // namespace

void writeCrashDumps(const CrashWriter& writer)
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
