#include "app/cli/add_warnings.h"
#include "app/cli/commands.h"
#include "app/texts/printable_text.h"
#include "io/study/read_studies.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

using Json = nlohmann::ordered_json;

const char* textOf(io::SeriesUse use)
{
    switch (use) {
        case io::SeriesUse::Vessels:
            return "vessels";
        case io::SeriesUse::View:
            return "view";
        case io::SeriesUse::None:
            break;
    }
    return "none";
}

Json seriesJson(const io::StudySeries& studySeries)
{
    const io::DicomSeries& series = studySeries.series;
    Json json{{"use", textOf(studySeries.use)},    {"seriesId", series.id},
              {"number", series.number},           {"modality", series.identity.modality},
              {"description", series.description}, {"bodyPart", studySeries.bodyPart},
              {"images", studySeries.imageCount}};
    if (series.part) {
        json["part"] = series.part->text();
    }
    if (!series.slices.empty()) {
        json["size"] = {series.slices.front().size.x(), series.slices.front().size.y()};
    }
    if (studySeries.use == io::SeriesUse::Vessels) {
        json["sliceSpacingMm"] = series.stack.geometry.spacingMm.z();
    }
    if (studySeries.frameTimeMs > 0.0 && series.isAngiogram) {
        json["framesPerSecond"] = 1000.0 / studySeries.frameTimeMs;
    }
    if (!studySeries.place.empty()) {
        json["place"] = studySeries.place;
    }
    if (studySeries.missingFiles > 0) {
        json["missingFiles"] = studySeries.missingFiles;
    }
    if (studySeries.reason) {
        json["reason"] = studySeries.reason->text();
    }
    addWarnings(json, series.warnings);
    return json;
}

Json studyJson(const io::Study& study)
{
    Json json{{"studyUid", study.identity.studyUid},
              {"date", study.identity.studyDate},
              {"description", study.description},
              {"accessionNumber", study.identity.accessionNumber},
              {"series", Json::array()}};
    for (const io::StudySeries& series : study.series) {
        json["series"].push_back(seriesJson(series));
    }
    return json;
}

Json directoryJson(const io::DirectoryCheck& check)
{
    if (check.damage) {
        return {{"damage", check.damage->text()}};
    }
    return {{"series", check.series},
            {"files", check.files},
            {"missingFiles", check.missingFiles},
            {"unlistedFiles", check.unlistedFiles}};
}

Json treeJson(const io::StudyTree& tree)
{
    Json json{{"files", tree.readFiles}, {"otherFiles", tree.otherFiles}, {"patients", Json::array()}};
    for (const io::StudyPatient& patient : tree.patients) {
        Json& added = json["patients"].emplace_back(Json{{"name", patient.identity.patientName},
                                                         {"id", patient.identity.patientId},
                                                         {"birthDate", patient.identity.birthDate},
                                                         {"studies", Json::array()}});
        for (const io::Study& study : patient.studies) {
            added["studies"].push_back(studyJson(study));
        }
    }
    if (tree.directory) {
        json["dicomdir"] = directoryJson(*tree.directory);
    }
    json["damaged"] = Json::array();
    for (const io::DamagedFile& file : tree.damagedFiles) {
        json["damaged"].push_back({{"file", file.path}, {"reason", file.reason.text()}});
    }
    return json;
}

std::string joinedParts(std::initializer_list<std::string> parts)
{
    std::string line;
    for (const std::string& part : parts) {
        line += part.empty() ? "" : (line.empty() ? "" : "  ") + part;
    }
    return line;
}

void printSeries(const io::StudySeries& studySeries)
{
    const io::DicomSeries& series = studySeries.series;
    char spacing[48] = "";
    if (studySeries.use == io::SeriesUse::Vessels) {
        std::snprintf(spacing, sizeof spacing, "%.2f mm spacing", series.stack.geometry.spacingMm.z());
    } else if (studySeries.use == io::SeriesUse::View && studySeries.frameTimeMs > 0.0) {
        std::snprintf(spacing, sizeof spacing, "%.1f frames/s", 1000.0 / studySeries.frameTimeMs);
    }
    const bool isRun = series.isAngiogram;
    const std::string count = std::to_string(studySeries.imageCount) + (isRun ? " frames" : " images");
    const std::string size =
        series.slices.empty() || series.slices.front().size.x() == 0
            ? ""
            : std::to_string(series.slices.front().size.x()) + " x " + std::to_string(series.slices.front().size.y());
    const std::string missing =
        studySeries.missingFiles > 0 ? std::to_string(studySeries.missingFiles) + " files missing" : "";
    const std::string line =
        joinedParts({std::to_string(series.number), series.identity.modality, series.description,
                     series.part ? series.part->text() : "", studySeries.bodyPart, count, size, spacing, missing});
    std::printf("    %-7s  %s\n", textOf(studySeries.use), printableText(line).c_str());
    printText("             " + (studySeries.reason ? studySeries.reason->text() : "series " + series.id));
    for (const core::Message& warning : series.warnings) {
        printText("             warning: " + warning.text());
    }
}

void printTree(const io::StudyTree& tree)
{
    for (const io::StudyPatient& patient : tree.patients) {
        const core::StudyIdentity& who = patient.identity;
        const std::string name = who.patientName.empty() ? "(no name)" : who.patientName;
        printText(joinedParts({name, who.patientId, who.birthDate}));
        for (const io::Study& study : patient.studies) {
            printText("  " +
                      joinedParts({study.identity.studyDate, study.description, study.identity.accessionNumber}));
            for (const io::StudySeries& series : study.series) {
                printSeries(series);
            }
        }
    }
    std::printf("%zu files read, %zu of them not DICOM, %zu damaged\n", tree.readFiles, tree.otherFiles,
                tree.damagedFiles.size());
    for (const io::DamagedFile& file : tree.damagedFiles) {
        printText("  damaged: " + file.path + ": " + file.reason.text());
    }
    if (tree.directory && tree.directory->damage) {
        printText("The DICOMDIR is damaged: " + tree.directory->damage->text() +
                  "; the files were read directly instead.");
    } else if (tree.directory) {
        std::printf(
            "The DICOMDIR lists %zu series in %zu files, of which %zu are missing; %zu other files are not listed.\n",
            tree.directory->series, tree.directory->files, tree.directory->missingFiles, tree.directory->unlistedFiles);
    }
}

}   // namespace

int runStudies(const FileArguments& arguments)
{
    ProgressLine line("reading");
    const auto observe = [&line](const io::StudyProgress& progress) {
        const auto all = static_cast<double>(std::max<std::size_t>(progress.found, 1));
        line.show(static_cast<double>(progress.read) / all,
                  std::to_string(progress.read) + " of " + std::to_string(progress.found) + " files");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    };
    const auto tree = io::readStudies(arguments.path,
                                      arguments.allFiles ? io::StudyScope::AllFiles : io::StudyScope::Listed, observe);
    if (!tree) {
        return reportInputError(tree.error(), arguments.format);
    }
    if (arguments.format == OutputFormat::Json) {
        std::puts(treeJson(tree.value()).dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    } else {
        printTree(tree.value());
    }
    return tree.value().isStopped ? exitInterrupted : exitSuccess;
}

}   // namespace angiopose::app
