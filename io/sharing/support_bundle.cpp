#include "io/sharing/support_bundle.h"

#include "io/sharing/zip_archive.h"
#include "io/support/atomic_file.h"
#include "io/support/crash_dumps.h"
#include "io/support/library_versions.h"
#include "io/support/scratch_folder.h"
#include "io/support/system/current_process.h"
#include "io/support/system/machine_info.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t dumpsInBundle = 5;

std::string machineText()
{
    const MachineInfo facts = machineInfo();
    const auto gibibytes = static_cast<long>(physicalMemoryBytes() / (1024.0 * 1024.0 * 1024.0) + 0.5);
    return "system: " + facts.system + "\nprocessor: " + facts.processor + ", " + std::to_string(facts.cores) +
           " cores\nmemory: " + std::to_string(gibibytes) + " GiB\n";
}

}   // namespace

std::vector<SupportFile> diagnosticFiles(const std::string& additionalInfo)
{
    std::vector<SupportFile> texts{{"program.txt", buildInfo() + machineText() + additionalInfo}};
    const auto dumps = crashDumps();
    for (std::size_t i = 0; i < std::min(dumps.size(), dumpsInBundle); ++i) {
        texts.push_back({"fault-" + std::to_string(i + 1) + ".txt", demangleDump(dumps[i])});
    }
    return texts;
}

std::vector<SupportFile> redact(std::vector<SupportFile> texts, const Redaction& redaction)
{
    for (SupportFile& each : texts) {
        each.text = redaction.redact(each.text);
    }
    return texts;
}

std::string joinTexts(const std::vector<SupportFile>& texts)
{
    std::string all;
    for (const SupportFile& each : texts) {
        all += (all.empty() ? "" : "\n") + std::string("== ") + each.name + "\n" + each.text;
    }
    return all;
}

core::Status writeSupportBundle(const std::vector<SupportFile>& texts, const std::string& archivePath)
{
    const ScratchFolder folder(archivePath);
    if (const auto made = folder.make(); !made) {
        return made.error();
    }
    for (const SupportFile& each : texts) {
        if (const auto written = writeAtomically((folder.path() / each.name).string(), each.text); !written) {
            return written.error();
        }
    }
    return writeZip(folder.path().string(), archivePath);
}

}   // namespace angiopose::io
