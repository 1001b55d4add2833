#pragma once

#include "core/support/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

enum class AuditEvent { Opened, Saved, Registered, Exported, Packed, Sent, Retrieved, Received, Deidentified };

/// "opened", "saved", …
std::string_view toText(AuditEvent event);

struct AuditRecord {
    AuditEvent event = AuditEvent::Opened;
    std::string program;   ///< "angiopose"
    std::vector<std::string> paths;   ///< files and folders that the event concerns
    std::string archive{};   ///< archive with which they were exchanged; may be empty
};

/// Appends a line of JSON to the audit file (FORMATS §4): time in UTC, account, program and version, event, and the
/// SHA-256 of every file (for a folder, of each file in it). Reads the files completely. Fails if the line cannot be
/// written.
core::Status recordAudit(const std::string& auditPath, const AuditRecord& record);

/// Returns the path in `ANGIOPOSE_AUDIT_FILE`; empty: no audit file.
std::string auditFileOfEnvironment();

/// Records files that arrive one after another, many per audit line and shortly after they arrive. Without a path of
/// the audit file nothing is recorded.
class AuditBatch {
public:
    AuditBatch(std::string auditPath, AuditRecord about);

    void add(const std::string& path);
    /// Writes a line once enough files wait or the first has waited long enough; to be called periodically.
    void noteWhenDue();
    void noteAll();

    /// Returns why the last line could not be written; nullopt if all were written.
    const std::optional<core::Message>& problem() const { return problem_; }

private:
    std::string auditPath_;
    AuditRecord record_;
    std::chrono::steady_clock::time_point waitsSince_;
    std::optional<core::Message> problem_;
};

}   // namespace angiopose::io
