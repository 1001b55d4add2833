#include "tests/mutants/limited_run.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cstdio>
#include <vector>

// reading_table OLD NEW [FOLDER] Passes every file below FOLDER (the test data) to `info` of two builds of the command
// line, one after the other, and compares their output, exit codes, processor time (minimum of three runs) and peak
// memory. Lists files that differ and files that take long; the last lines sum up. Each time includes starting the
// program.

using namespace angiopose;

namespace {

constexpr test::RunLimits limits{0, 120};
constexpr int repetitions = 3;
constexpr double worthListing = 0.3;   // seconds

struct Reading {
    test::LimitedRun run;
    std::string said;
};

Reading readingOf(const std::string& program, const std::string& path, const test::TemporaryFolder& folder)
{
    Reading reading;
    for (int i = 0; i < repetitions; ++i) {
        const test::LimitedRun run = test::runLimited({program, "info", path}, limits, folder.file("said"));
        const double least = i == 0 ? run.cpuSeconds : std::min(reading.run.cpuSeconds, run.cpuSeconds);
        reading.run = run;
        reading.run.cpuSeconds = least;
    }
    reading.said = test::readText(folder.file("said"));
    return reading;
}

std::vector<std::string> filesBelow(const std::string& folder)
{
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

void printRatios(const char* what, std::vector<double> ratios)
{
    std::sort(ratios.begin(), ratios.end());
    std::printf("%s new / old: median %.2f, nine of ten below %.2f, most %.2f\n", what, ratios[ratios.size() / 2],
                ratios[ratios.size() * 9 / 10], ratios.back());
}

}   // namespace

int main(int count, char** values)
{
    if (count < 3) {
        std::puts("Usage: reading_table OLD NEW [FOLDER]");
        return 2;
    }
    const test::TemporaryFolder folder;
    std::vector<double> timeRatios, memoryRatios;
    int different = 0;
    for (const std::string& path : filesBelow(count > 3 ? values[3] : TEST_DATA_DIR)) {
        const Reading before = readingOf(values[1], path, folder), after = readingOf(values[2], path, folder);
        const bool isSame = before.said == after.said && before.run.exitCode == after.run.exitCode;
        timeRatios.push_back(after.run.cpuSeconds / before.run.cpuSeconds);
        memoryRatios.push_back(static_cast<double>(after.run.peakKilobytes) /
                               static_cast<double>(before.run.peakKilobytes));
        different += isSame ? 0 : 1;
        if (!isSame || before.run.cpuSeconds > worthListing) {
            std::printf("%s%s: exit %d %d, %.2f %.2f s, %ld %ld MB\n", isSame ? "" : "differs: ", path.c_str(),
                        before.run.exitCode, after.run.exitCode, before.run.cpuSeconds, after.run.cpuSeconds,
                        before.run.peakKilobytes / 1024, after.run.peakKilobytes / 1024);
        }
    }
    if (timeRatios.empty()) {
        std::puts("There is no file.");
        return 2;
    }
    std::printf("%zu files, %d read differently\n", timeRatios.size(), different);
    printRatios("processor time", timeRatios);
    printRatios("peak memory", memoryRatios);
    return 0;
}
