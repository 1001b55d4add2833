#include "tests/cli/batch_files.h"

#include "tests/support/temporary_folder.h"

#include <unistd.h>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

namespace angiopose::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void dropTimes(json& value)
{
    if (value.is_object()) {
        for (const char* key : {"timeMs", "times", "time", "modified", "found"}) {
            value.erase(key);
        }
    }
    if (value.is_structured()) {
        for (json& each : value) {
            dropTimes(each);
        }
    }
}

/// A PNG without its text chunks, which contain the creation time.
std::string withoutTexts(const std::string& png)
{
    std::string rest = png.substr(0, 8);
    for (std::size_t at = 8; at + 12 <= png.size();) {
        std::size_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            size = 256 * size + static_cast<unsigned char>(png[at + i]);
        }
        if (png.compare(at + 4, 4, "iTXt") != 0) {
            rest += png.substr(at, size + 12);
        }
        at += size + 12;
    }
    return rest;
}

std::string lasting(const fs::path& path)
{
    const std::string content = readText(path);
    if (path.extension() == ".json") {
        json value = json::parse(content, nullptr, false);
        if (value.value("format", "") ==
            "angiopose-batch-outcome") {   // images and results contain times, hence vary in length
            value.erase("files");
        }
        dropTimes(value);
        return value.dump();
    }
    return path.extension() == ".png" ? withoutTexts(content) : content;
}

/// Facts about a process: its parent, and whether its command line marks it as a batch worker.
struct ProcessFacts {
    pid_t parent = -1;
    bool isBatchWorker = false;
};

ProcessFacts factsOf(const fs::path& folder)
{
    std::string stat = readText(folder / "stat");
    std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
    std::string state;
    ProcessFacts facts;
    fields >> state >> facts.parent;
    facts.isBatchWorker = readText(folder / "cmdline").find("batch-worker") != std::string::npos;
    return facts;
}

}   // namespace

std::map<std::string, std::string> lastingContentOf(const std::string& folder)
{
    std::map<std::string, std::string> contents;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = fs::relative(entry.path(), folder).string();
        if (entry.is_regular_file() && !name.starts_with("times") && !name.starts_with("summary-")) {
            contents[name] = lasting(entry.path());
        }
    }
    return contents;
}

pid_t parentOf(pid_t process)
{
    return factsOf("/proc/" + std::to_string(process)).parent;
}

std::vector<pid_t> batchWorkers()
{
    std::vector<pid_t> workers;
    std::error_code gone;
    for (const auto& entry : fs::directory_iterator("/proc", gone)) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) {
            continue;
        }
        const ProcessFacts facts = factsOf(entry.path());
        if (facts.isBatchWorker && factsOf("/proc/" + std::to_string(facts.parent)).parent == getpid()) {
            workers.push_back(static_cast<pid_t>(std::stol(name)));
        }
    }
    return workers;
}

}   // namespace angiopose::test
