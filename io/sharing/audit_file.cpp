#include "io/sharing/audit_file.h"

#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/support/files_in_folder.h"
#include "io/support/system/appended_line.h"
#include "io/support/system/machine_info.h"
#include "io/support/system/signal_text.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json entryOf(const std::string& path)
{
    Json entry{{"path", path}};
    const auto hash = sha256OfFile(path);
    if (hash) {
        entry["sha256"] = hash.value();
    } else {
        entry["unread"] = true;
    }
    return entry;
}

void addFiles(const std::string& path, Json& files)
{
    std::error_code failed;
    const std::string absolute = fs::absolute(path, failed).lexically_normal().string();
    if (!fs::is_directory(absolute, failed)) {
        files.push_back(entryOf(absolute));
        return;
    }
    if (const auto inside = filesInFolder(absolute, FolderDepth::Recursive)) {
        for (const std::string& file : inside.value()) {
            files.push_back(entryOf(file));
        }
    }
}

std::string timeNow()
{
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return SignalTime(std::chrono::duration_cast<std::chrono::seconds>(now).count()).text.data();
}

constexpr std::size_t maxWaiting = 200;
constexpr std::chrono::seconds maxWait{2};   // maximum time for which events of a killed program may remain unrecorded

}   // namespace

std::string_view toText(AuditEvent event)
{
    switch (event) {
        case AuditEvent::Opened:
            return "opened";
        case AuditEvent::Saved:
            return "saved";
        case AuditEvent::Registered:
            return "registered";
        case AuditEvent::Exported:
            return "exported";
        case AuditEvent::Packed:
            return "packed";
        case AuditEvent::Sent:
            return "sent";
        case AuditEvent::Retrieved:
            return "retrieved";
        case AuditEvent::Received:
            return "received";
        case AuditEvent::Deidentified:
            break;
    }
    return "deidentified";
}

core::Status recordAudit(const std::string& auditPath, const AuditRecord& record)
{
    Json line{{"time", timeNow()},
              {"user", accountName()},
              {"program", record.program},
              {"version", ANGIOPOSE_VERSION},
              {"event", std::string(toText(record.event))}};
    if (!record.archive.empty()) {
        line["archive"] = record.archive;
    }
    line["files"] = Json::array();
    for (const std::string& path : record.paths) {
        addFiles(path, line["files"]);
    }
    const std::string problem = appendLine(auditPath, line.dump(-1, ' ', false, Json::error_handler_t::replace));
    return problem.empty() ? core::Status(core::Done{})
                           : core::Error(messages::auditNotWritten(problem).about(auditPath));
}

std::string auditFileFromEnvironment()
{
    const char* path = std::getenv("ANGIOPOSE_AUDIT_FILE");
    return path != nullptr ? path : "";
}

AuditBatch::AuditBatch(std::string auditPath, AuditRecord about)
    : auditPath_(std::move(auditPath)), record_(std::move(about))
{
}

void AuditBatch::add(const std::string& path)
{
    if (auditPath_.empty()) {
        return;
    }
    if (record_.paths.empty()) {
        pendingSince_ = std::chrono::steady_clock::now();
    }
    record_.paths.push_back(path);
}

void AuditBatch::flushIfDue()
{
    const bool hasWaited = std::chrono::steady_clock::now() - pendingSince_ >= maxWait;
    if (record_.paths.size() >= maxWaiting || (!record_.paths.empty() && hasWaited)) {
        flush();
    }
}

void AuditBatch::flush()
{
    if (record_.paths.empty()) {
        return;
    }
    if (const core::Status written = recordAudit(auditPath_, record_); !written) {
        problem_ = written.error().message;
    }
    record_.paths.clear();
}

}   // namespace angiopose::io
