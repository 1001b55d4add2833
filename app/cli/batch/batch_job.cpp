#include "app/cli/batch/batch_job.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

using JobJson = nlohmann::ordered_json;

/// Serializes to JSON; replaces invalid UTF-8 in file names and other strings.
std::string textOf(const JobJson& json)
{
    return json.dump(-1, ' ', false, JobJson::error_handler_t::replace);
}

/// Members of `asked` that describe the settings common to all rows.
constexpr const char* commonKeys[] = {"set", "programVersion"};

JobJson commonOf(const JobJson& request)
{
    JobJson common;
    for (const char* key : commonKeys) {
        common[key] = request.value(key, JobJson());
    }
    return common;
}

JobJson withoutCommon(JobJson request)
{
    for (const char* key : commonKeys) {
        request.erase(key);
    }
    return request;
}

}   // namespace

std::string serializeRequest(const io::BatchEntry& entry, const io::CaseSettings& common)
{
    JobJson request = JobJson::object();
    const auto add = [&request](const char* key, const std::string& cell) {
        if (!cell.empty()) {
            request[key] = cell;
        }
    };
    add("case", entry.caseCell);
    add("vessels", entry.vesselsCell);
    add("angiogram", entry.angiogramCell);
    add("method", entry.method);
    if (entry.frame) {
        request["frame"] = *entry.frame;
    }
    if (!entry.settings.isEmpty()) {
        request["settings"] = entry.settings.assignments();
    }
    request["set"] = common.assignments();
    request["programVersion"] = ANGIOPOSE_VERSION;
    return textOf(request);
}

bool isSameRow(const std::string& request, const std::string& other)
{
    return withoutCommon(JobJson::parse(request)) == withoutCommon(JobJson::parse(other));
}

bool haveSameSettings(const std::string& request, const std::string& other)
{
    return commonOf(JobJson::parse(request)) == commonOf(JobJson::parse(other));
}

BatchJob makeJob(const io::BatchEntry& entry, const io::CaseSettings& common, const std::string& outputFolder)
{
    BatchJob job;
    job.name = entry.name;
    job.casePath = entry.casePath;
    job.vesselsPath = entry.vesselsPath;
    job.angiogramPath = entry.angiogramPath;
    job.method = entry.method;
    job.frame = entry.frame;
    job.settings = common.assignments();
    for (const std::string& own :
         entry.settings.assignments()) {   // the row's own settings come last, to override the common ones
        job.settings.push_back(own);
    }
    job.folder = (std::filesystem::absolute(outputFolder) / entry.name).string();
    job.request = serializeRequest(entry, common);
    return job;
}

std::string toJsonLine(const BatchJob& job)
{
    JobJson json{{"name", job.name},           {"case", job.casePath},
                 {"vessels", job.vesselsPath}, {"angiogram", job.angiogramPath},
                 {"method", job.method},       {"settings", job.settings},
                 {"folder", job.folder},       {"asked", job.request},
                 {"isResumed", job.resumes},   {"isWithoutPictures", job.skipImages}};
    if (job.frame) {
        json["frame"] = *job.frame;
    }
    return json.dump(-1, ' ', true, JobJson::error_handler_t::replace);
}

BatchJob parseJob(const std::string& line)
{
    const JobJson json = JobJson::parse(line);
    BatchJob job;
    job.name = json.at("name");
    job.casePath = json.at("case");
    job.vesselsPath = json.at("vessels");
    job.angiogramPath = json.at("angiogram");
    job.method = json.at("method");
    job.settings = json.at("settings").get<std::vector<std::string>>();
    job.folder = json.at("folder");
    job.request = json.at("asked");
    job.resumes = json.at("isResumed");
    job.skipImages = json.at("isWithoutPictures");
    if (json.contains("frame")) {
        job.frame = json["frame"].get<int>();
    }
    return job;
}

}   // namespace angiopose::app
