#include "core/support/random.h"
#include "tests/cli/batch_files.h"
#include "tests/support/temporary_folder.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <thread>

// batch_kills ANGIOPOSE-CLI [--cases N] [--kills N] [--seed N] [--folder DIR] [--measure 1]
// Registers N simulated cases in one undisturbed batch, then in another batch that is killed at the given number of
// random moments and resumed after each. Counts cases that are lost, duplicated, repeated or different; fails if there
// are any. `--measure 1` also compares two workers with one, and batches without images. With a folder, the cases are
// kept there for the next call.

using namespace angiopose;

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Settings {
    std::string program;
    int cases = 1000;
    int kills = 20;
    std::uint64_t seed = 20261126;
    std::string folder;
    bool isMeasured = false;
};

int faults = 0;

void complain(const std::string& what)
{
    ++faults;
    std::printf("  FAULT: %s\n", what.c_str());
}

/// Starts a program and discards its output.
pid_t start(std::vector<std::string> words)
{
    const pid_t child = ::fork();
    if (child == 0) {
        if (std::freopen("/dev/null", "w", stdout) == nullptr || std::freopen("/dev/null", "w", stderr) == nullptr) {
            ::_exit(127);
        }
        std::vector<char*> pointers;
        for (std::string& word : words) {
            pointers.push_back(word.data());
        }
        pointers.push_back(nullptr);
        ::execv(pointers.front(), pointers.data());
        ::_exit(127);
    }
    return child;
}

struct Ending {
    int code = -1;   ///< negative: the signal
    double seconds = 0.0;
    double cpuSeconds = 0.0;   ///< including its workers
};

Ending endOf(pid_t child, Clock::time_point begun)
{
    int status = 0;
    rusage usage{};
    ::wait4(child, &status, 0, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            std::chrono::duration<double>(Clock::now() - begun).count(),
            seconds(usage.ru_utime) + seconds(usage.ru_stime)};
}

std::string nameOf(int number)
{
    return "case-" + std::to_string(number);
}

void simulateCases(const Settings& settings)
{
    std::string rows = "case,name\n";
    for (int i = 1; i <= settings.cases; ++i) {
        const fs::path folder = fs::path(settings.folder) / nameOf(i);
        rows += nameOf(i) + "/case.angiopose," + nameOf(i) + "\n";
        if (!fs::exists(folder / "case.angiopose")) {
            const auto begun = Clock::now();
            if (endOf(start({settings.program, "simulate", "--seed", std::to_string(i), "--output", folder}), begun)
                    .code != 0) {
                complain("seed " + std::to_string(i) + " is not simulated");
            }
        }
    }
    test::writeText(fs::path(settings.folder) / "cases.csv", rows);
}

using Words = std::vector<std::string>;

Words batchWords(const Settings& settings, const std::string& output, int threads)
{
    const fs::path folder(settings.folder);
    return {settings.program, "batch",     folder / "cases.csv",    "--output",
            folder / output,  "--threads", std::to_string(threads), "--resume"};
}

Ending runQuietly(const Settings& settings, const std::string& output, int threads, const Words& more = {})
{
    fs::remove_all(fs::path(settings.folder) / output);
    Words words = batchWords(settings, output, threads);
    words.insert(words.end(), more.begin(), more.end());
    const auto begun = Clock::now();
    const Ending ending = endOf(start(words), begun);
    if (ending.code != 0 && ending.code != 4) {
        complain("the quiet run ends with " + std::to_string(ending.code));
    }
    return ending;
}

using Finished = std::map<std::string, fs::file_time_type>;

Finished finishedIn(const fs::path& output)
{
    Finished finished;
    std::error_code absent;
    for (const auto& entry : fs::directory_iterator(output, absent)) {
        const fs::path outcome = entry.path() / "outcome.json";
        if (fs::exists(outcome, absent)) {
            finished[entry.path().filename()] = fs::last_write_time(outcome);
        }
    }
    return finished;
}

/// Checks that cases finished earlier are unchanged: neither lost nor repeated.
void checkKept(const Finished& before, const Finished& now)
{
    for (const auto& [name, time] : before) {
        const auto found = now.find(name);
        if (found == now.end()) {
            complain(name + " was finished and is lost");
        } else if (found->second != time) {
            complain(name + " was finished and is done again");
        }
    }
}

void killAndResume(const Settings& settings, double quietSeconds)
{
    core::CounterRandom random(settings.seed);
    const fs::path output = fs::path(settings.folder) / "killed";
    fs::remove_all(output);
    Finished finished;
    int killed = 0;
    for (int i = 0; i < settings.kills; ++i) {
        const pid_t child = start(batchWords(settings, "killed", 2));
        // Chosen so that work is left even for the last kills.
        const double seconds = 1.2 * quietSeconds / settings.kills * random.uniform();
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
        ::kill(child, SIGKILL);
        killed += endOf(child, Clock::now()).code == -SIGKILL ? 1 : 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));   // its workers end with it
        const Finished now = finishedIn(output);
        checkKept(finished, now);
        finished = now;
    }
    const std::size_t left = static_cast<std::size_t>(settings.cases) - finished.size();
    const Ending last = endOf(start(batchWords(settings, "killed", 2)), Clock::now());
    checkKept(finished, finishedIn(output));
    if (last.code != 0 && last.code != 4) {
        complain("the last run ends with " + std::to_string(last.code));
    }
    std::printf("%d of %d runs killed, %zu cases finished meanwhile, %zu by the last run\n", killed, settings.kills,
                finished.size(), left);
}

std::map<std::string, int> rowsOf(const std::string& table)
{
    std::map<std::string, int> rows;
    for (std::size_t begin = table.find('\n') + 1; begin < table.size(); begin = table.find('\n', begin) + 1) {
        const std::size_t name = table.find('"', begin) + 1;
        ++rows[table.substr(name, table.find('"', name) - name)];
    }
    return rows;
}

void compare(const Settings& settings)
{
    const fs::path folder(settings.folder);
    const std::string quiet = test::readText(folder / "quiet/summary.csv");
    const std::string killed = test::readText(folder / "killed/summary.csv");
    const auto rows = rowsOf(killed);
    int lost = 0, doubled = 0, different = 0;
    for (int i = 1; i <= settings.cases; ++i) {
        const std::string name = nameOf(i);
        const auto found = rows.find(name);
        lost += found == rows.end() ? 1 : 0;
        doubled += found != rows.end() && found->second > 1 ? 1 : 0;
        different +=
            test::lastingContentOf(folder / "quiet" / name) == test::lastingContentOf(folder / "killed" / name) ? 0 : 1;
    }
    const bool isSame = quiet == killed;
    std::printf("%zu rows, %d lost, %d doubled; table of the quiet run: %s; cases whose files differ: %d\n",
                rows.size(), lost, doubled, isSame ? "the same bytes" : "DIFFERENT", different);
    faults += lost + doubled + different + (isSame ? 0 : 1);
}

void tell(const Settings& settings, const char* what, const Ending& run)
{
    std::printf("%s: %.0f cases per hour, %.0f per hour of processor (%.1f s of wall, %.1f s of processor)\n", what,
                3600.0 * settings.cases / run.seconds, 3600.0 * settings.cases / run.cpuSeconds, run.seconds,
                run.cpuSeconds);
}

void measure(const Settings& settings, const Ending& one)
{
    tell(settings, "one worker", one);
    if (settings.isMeasured) {
        const Ending two = runQuietly(settings, "two", 2);
        tell(settings, "two workers", two);
        std::printf("two workers are %.2f times as fast as one\n", one.seconds / two.seconds);
        const Ending bare = runQuietly(settings, "bare", 1, {"--no-pictures"});
        tell(settings, "one worker, no pictures", bare);
        const Ending twoBare = runQuietly(settings, "two-bare", 2, {"--no-pictures"});
        tell(settings, "two workers, no pictures", twoBare);
        std::printf("two workers are %.2f times as fast as one without pictures\n", bare.seconds / twoBare.seconds);
    }
}

Settings settingsFrom(int count, char** values)
{
    Settings settings;
    settings.program = values[1];
    for (int i = 2; i + 1 < count; i += 2) {
        const std::string name = values[i];
        const std::string value = values[i + 1];
        if (name == "--cases") {
            settings.cases = std::stoi(value);
        } else if (name == "--kills") {
            settings.kills = std::stoi(value);
        } else if (name == "--seed") {
            settings.seed = std::stoull(value);
        } else if (name == "--folder") {
            settings.folder = value;
        } else if (name == "--measure") {
            settings.isMeasured = value == "1";
        }
    }
    return settings;
}

}   // namespace

int main(int count, char** values)
{
    if (count < 2) {
        std::printf("batch_kills ANGIOPOSE-CLI [--cases N] [--kills N] [--seed N] [--folder DIR] [--measure 1]\n");
        return 2;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const test::TemporaryFolder temporary;
    Settings settings = settingsFrom(count, values);
    settings.folder = settings.folder.empty() ? temporary.file("batch") : settings.folder;
    fs::create_directories(settings.folder);
    simulateCases(settings);
    const Ending quiet = runQuietly(settings, "quiet", 1);
    measure(settings, quiet);
    killAndResume(settings, quiet.seconds);
    compare(settings);
    std::printf("%d faults\n", faults);
    return faults == 0 ? 0 : 1;
}
