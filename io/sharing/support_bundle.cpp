#include "io/sharing/support_bundle.h"

#include "io/sharing/zip_archive.h"
#include "io/support/atomic_file.h"
#include "io/support/crash_dumps.h"
#include "io/support/library_versions.h"
#include "io/support/scratch_folder.h"
#include "io/support/system/machine_facts.h"
#include "io/support/system/own_process.h"

#include <algorithm>

namespace angiopose::io {
namespace {

constexpr std::size_t dumpsInBundle = 5;

std::string machineText()
{
    const MachineFacts facts = machineFacts();
    const auto gibibytes = static_cast<long>(memoryBytes() / (1024.0 * 1024.0 * 1024.0) + 0.5);
    return "system: " + facts.system + "\nprocessor: " + facts.processor + ", " + std::to_string(facts.cores) +
           " cores\nmemory: " + std::to_string(gibibytes) + " GiB\n";
}

}   // namespace

std::vector<SupportText> programTexts(const std::string& furtherFacts)
{
    std::vector<SupportText> texts{{"program.txt", buildFacts() + machineText() + furtherFacts}};
    const auto dumps = crashDumps();
    for (std::size_t i = 0; i < std::min(dumps.size(), dumpsInBundle); ++i) {
        texts.push_back({"fault-" + std::to_string(i + 1) + ".txt", readableDump(dumps[i])});
    }
    return texts;
}

std::vector<SupportText> cleaned(std::vector<SupportText> texts, const Redaction& redaction)
{
    for (SupportText& each : texts) {
        each.text = redaction.cleaned(each.text);
    }
    return texts;
}

std::string asOneText(const std::vector<SupportText>& texts)
{
    std::string all;
    for (const SupportText& each : texts) {
        all += (all.empty() ? "" : "\n") + std::string("== ") + each.name + "\n" + each.text;
    }
    return all;
}

core::Status writeSupportBundle(const std::vector<SupportText>& texts, const std::string& archivePath)
{
    const ScratchFolder folder(archivePath);
    if (const auto made = folder.make(); !made) {
        return made.error();
    }
    for (const SupportText& each : texts) {
        if (const auto written = writeAtomically((folder.path() / each.name).string(), each.text); !written) {
            return written.error();
        }
    }
    return writeZip(folder.path().string(), archivePath);
}

}   // namespace angiopose::io
