#include "tests/mutants/limited_run.h"
#include "tests/mutants/mutate.h"
#include "tests/mutants/small_files.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

// mutant_run CLI [--trials N] [--seed N] [--only NAME] [--keep FOLDER]
// Gives damaged files of every format to `CLI info` (surfaces also to `CLI trace-vessel`, a DICOMDIR next to its disc
// to `CLI studies`), each in a process with 3 GB of address space and 10 s of processor time. Everything other than
// exit code 0 or 3 (4 when tracing) is reported and kept in FOLDER.

using namespace angiopose;

namespace {

constexpr test::RunLimits limits{std::size_t{3} << 30, 10};

struct Arguments {
    std::string program;
    int trials = 300;
    std::uint64_t seed = 20261123;
    std::string only;
    std::string keep;
};

Arguments argumentsOf(int count, char** values)
{
    Arguments arguments;
    arguments.program = count > 1 ? values[1] : "";
    for (int i = 2; i + 1 < count; i += 2) {
        const std::string name = values[i];
        if (name == "--trials") {
            arguments.trials = std::atoi(values[i + 1]);
        } else if (name == "--seed") {
            arguments.seed = std::strtoull(values[i + 1], nullptr, 10);
        } else if (name == "--only") {
            arguments.only = values[i + 1];
        } else if (name == "--keep") {
            arguments.keep = values[i + 1];
        }
    }
    return arguments;
}

/// Describes an improper end of the program; empty if it ended properly.
std::string findFault(const test::LimitedRun& run)
{
    if (run.isTimedOut) {
        return "does not end";
    }
    if (run.signal != 0) {
        return std::string("dies of ") + strsignal(run.signal);
    }
    const bool isExpected = run.exitCode == 0 || run.exitCode == 3 || run.exitCode == 4;
    return isExpected ? std::string() : "ends with exit code " + std::to_string(run.exitCode);
}

/// Runs the program on mutants of one kind of file and returns the number of failures.
int faultsOf(const test::SmallFile& file, const Arguments& arguments, const test::TemporaryFolder& folder)
{
    core::CounterRandom random(arguments.seed);
    int faults = 0;
    for (int trial = 0; trial < arguments.trials; ++trial) {
        const std::string content = file.isGzip                   ? test::mutatedGzip(file.content, random)
                                    : file.name.ends_with(".png") ? test::mutatedPng(file.content, random)
                                                                  : test::mutated(file.content, random);
        const std::string path = folder.write(file.name, content);
        std::string fault =
            findFault(test::runLimited({arguments.program, file.isDisc ? "studies" : "info", path}, limits));
        if (fault.empty() && file.isSurface && trial % 4 == 0) {
            fault = findFault(test::runLimited(
                {arguments.program, "trace-vessel", path, "--output", folder.file("tree.csv")}, limits));
        }
        if (!fault.empty()) {
            ++faults;
            std::printf("  %s, mutant %d: %s\n", file.name.c_str(), trial, fault.c_str());
            if (!arguments.keep.empty()) {
                std::filesystem::create_directories(arguments.keep);
                test::writeText(arguments.keep + "/" + std::to_string(trial) + "-" + file.name, content);
            }
        }
    }
    return faults;
}

}   // namespace

int main(int count, char** values)
{
    const Arguments arguments = argumentsOf(count, values);
    if (arguments.program.empty()) {
        std::puts("Usage: mutant_run CLI [--trials N] [--seed N] [--only NAME] [--keep FOLDER]");
        return 2;
    }
    const test::TemporaryFolder folder;
    int faults = 0;
    for (const test::SmallFile& file : test::smallFiles(TEST_DATA_DIR, folder)) {
        if (arguments.only.empty() || file.name.find(arguments.only) != std::string::npos) {
            const int found = faultsOf(file, arguments, folder);
            std::printf("%-16s %d of %d mutants not survived\n", file.name.c_str(), found, arguments.trials);
            std::fflush(stdout);
            faults += found;
        }
    }
    std::printf("%d faults\n", faults);
    return faults == 0 ? 0 : 1;
}
