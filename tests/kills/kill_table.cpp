#include "core/support/random.h"
#include "io/support/file_limits.h"
#include "io/support/own_leftovers.h"
#include "tests/kills/autosave_job.h"
#include "tests/kills/kept_case.h"
#include "tests/kills/receive_job.h"
#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <thread>

// kill_table [--kills N] [--seed N]
// Kills programs at N random moments while they save a case, export, autosave and receive objects; lets programs save
// on full and read-only drives, and lets two of them save the same case. Counts what is incomplete or lost afterward;
// fails if there is anything.

using namespace angiopose;

namespace {

namespace fs = std::filesystem;

int faults = 0;

/// Starts another process of this program with a job and waits until it is working.
pid_t start(const std::string& job, const std::string& folder, const std::string& drive = "")
{
    int ready[2];
    if (::pipe(ready) != 0) {
        return -1;
    }
    const pid_t child = ::fork();
    if (child == 0) {
        const std::string descriptor = std::to_string(ready[1]);
        ::execl("/proc/self/exe", "kill_table", "--job", job.c_str(), folder.c_str(), descriptor.c_str(), drive.c_str(),
                nullptr);
        ::_exit(127);
    }
    ::close(ready[1]);
    char begun = 0;
    (void)!::read(ready[0], &begun, 1);
    ::close(ready[0]);
    return child;
}

int endOf(pid_t child)
{
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::size_t hiddenFilesIn(const std::string& folder)
{
    std::size_t hidden = 0;
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(folder, absent)) {
        hidden += entry.path().filename().string().starts_with('.') ? 1 : 0;
    }
    return hidden;
}

/// Job of a killed program, with functions that check the files it left.
struct KilledJob {
    std::string name;
    std::function<std::string(const std::string& folder)> findHalf;
    std::function<std::size_t(const std::string& folder)> left;   ///< temporary files and locks
    std::function<void(const std::string& folder)> startAgain;   ///< starts writing there, as the next program would
};

KilledJob fileJob(const std::string& name, std::string (*writtenIn)(const std::string& folder))
{
    const auto findHalf = [name, writtenIn](const std::string& folder) {
        const std::string written = writtenIn(folder);
        return test::findHalfWritten(name, folder) +
               (written != folder ? test::findHalfWritten(name, written) : std::string());
    };
    return {name, findHalf, [writtenIn](const std::string& folder) { return hiddenFilesIn(writtenIn(folder)); },
            [writtenIn](const std::string& folder) { io::removeLeftovers(writtenIn(folder)); }};
}

void killDuring(const KilledJob& job, int kills, core::CounterRandom& random)
{
    const test::TemporaryFolder place;
    const std::string folder = fs::path(place.file("x")).parent_path().string();
    test::writeSmallCase(folder);
    int half = 0;
    int unexpected = 0;
    std::size_t left = 0;
    std::size_t leftInTheEnd = 0;
    for (int i = 0; i < kills; ++i) {
        const pid_t child = start(job.name, folder);
        std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(1000 + 150'000 * random.uniform())));
        ::kill(child, SIGKILL);
        unexpected += endOf(child) == -SIGKILL ? 0 : 1;
        left += job.left(folder);
        if (const std::string found = job.findHalf(folder); !found.empty()) {
            ++half;
            std::printf("  half written after a kill while %s:%s\n", job.name.c_str(), found.c_str());
        }
        job.startAgain(folder);
        leftInTheEnd += job.left(folder);
    }
    faults += half + unexpected + static_cast<int>(leftInTheEnd);
    std::printf(
        "%-10s %4d kills, %d files half written, %zu temporary files and locks left, %zu after the next start, %d "
        "ended by themselves\n",
        job.name.c_str(), kills, half, left, leftInTheEnd, unexpected);
}

/// Checks that saving on such a drive is refused with a message and the old case stays intact; `drive` names the fault
/// of the folder.
void refuseOn(const char* drive)
{
    const test::TemporaryFolder place;
    const std::string folder = fs::path(place.file("x")).parent_path().string();
    const int exitCode = endOf(start("once", folder, drive));
    const bool isRight = exitCode == 3;
    faults += isRight ? 0 : 1;
    std::printf("%-10s %s\n", drive, isRight ? "refused with a sentence, the old case is whole" : "WRONG");
}

void saveTogether()
{
    const test::TemporaryFolder place;
    const std::string folder = fs::path(place.file("x")).parent_path().string();
    const std::string path = test::writeSmallCase(folder);
    const pid_t first = start("count", folder);
    const pid_t second = start("count", folder);
    const int a = endOf(first);
    const int b = endOf(second);
    const auto session = test::wholeCase(path);
    const int counted = session ? test::numberOf(*session) : -1;
    const bool isRight = a >= 0 && a < 255 && b >= 0 && b < 255 && a + b == counted;
    faults += isRight ? 0 : 1;
    std::printf("two at once: %d and %d saves written of 60 each, the others refused; %d of them in the case: %s\n", a,
                b, counted, isRight ? "none lost" : "WRONG");
}

/// Puts the case on a memory file system that is full or read-only if this process may mount one, otherwise under a
/// file size limit.
void makeDrive(const std::string& folder, const std::string& drive)
{
    const bool mayMount = ::unshare(CLONE_NEWNS) == 0 &&
                          ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                          ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=512k") == 0;
    test::writeSmallCase(folder);
    if (drive == "full" && mayMount) {
        std::string filling(4096, 'x');
        const int file = ::open((folder + "/filling").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        while (::write(file, filling.data(), filling.size()) > 0) {
        }
        ::close(file);
    } else if (drive == "read-only" && mayMount) {
        ::mount("tmpfs", folder.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr);
    } else if (drive == "read-only") {
        ::chmod(folder.c_str(), 0555);
    } else {
        const rlimit limit{1000, 1000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
}

int runAsChild(char** values)
{
    io::reportFileSizeLimit();
    const std::string job = values[2];
    const std::string folder = values[3];
    if (values[5] != nullptr && values[5][0] != '\0') {
        makeDrive(folder, values[5]);
    }
    const int ready = std::atoi(values[4]);
    return job == "autosave"  ? test::autosaveForEver(folder, ready)
           : job == "receive" ? test::receiveForEver(folder, ready)
                              : test::runJob(job, folder, ready);
}

}   // namespace

int main(int count, char** values)
{
    if (count >= 5 && std::strcmp(values[1], "--job") == 0) {
        return runAsChild(values);
    }
    int kills = 200;
    std::uint64_t seed = 20261126;
    for (int i = 1; i + 1 < count; i += 2) {
        if (std::strcmp(values[i], "--kills") == 0) {
            kills = std::atoi(values[i + 1]);
        } else if (std::strcmp(values[i], "--seed") == 0) {
            seed = std::strtoull(values[i + 1], nullptr, 10);
        }
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    core::CounterRandom random(seed);
    const auto itself = [](const std::string& folder) { return folder; };
    killDuring(fileJob("save", itself), (kills + 3) / 4, random);
    killDuring(fileJob("export", itself), (kills + 2) / 4, random);
    killDuring(fileJob("autosave", test::autosaveFolderOf), (kills + 1) / 4, random);
    killDuring({"receive", test::findHalfReceived, test::interruptedIn, test::receiveAgain}, kills / 4, random);
    refuseOn("full");
    refuseOn("read-only");
    refuseOn("limited");
    saveTogether();
    std::printf("%d faults\n", faults);
    return faults == 0 ? 0 : 1;
}
