#pragma once

#include "core/support/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace angiopose::io {

enum class AuditEvent { Opened, Saved, Registered, Exported, Packed, Sent, Retrieved, Received, Deidentified };

/// Returns the name of the event in the audit file: "opened", "saved", …
std::string_view toText(AuditEvent event);

struct AuditRecord {
    AuditEvent event = AuditEvent::Opened;
    std::string program;   ///< program name, for example "angiopose"
    std::vector<std::string> paths;   ///< files and folders that the event concerns
    std::string archive{};   ///< archive with which the files were exchanged; may be empty
};

/// Appends a line of JSON to the audit file (FORMATS §4): UTC time, account, program and version, event, and the
/// SHA-256 of every file, including those in folders, which requires reading all files completely. Fails if the line
/// cannot be written.
core::Status recordAudit(const std::string& auditPath, const AuditRecord& record);

/// Returns the path in `ANGIOPOSE_AUDIT_FILE`; if empty, no audit file is written.
std::string auditFileFromEnvironment();

/// Records files that arrive one after another, shortly after arrival and many per audit line. Records nothing if the
/// path of the audit file is empty.
class AuditBatch {
public:
    AuditBatch(std::string auditPath, AuditRecord about);

    void add(const std::string& path);
    /// Writes a line if enough files are pending or the first one is old enough. Must be called periodically.
    void flushIfDue();
    void flush();

    /// Explains why the last line could not be written; nullopt if all lines were written.
    const std::optional<core::Message>& problem() const { return problem_; }

private:
    std::string auditPath_;
    AuditRecord record_;
    std::chrono::steady_clock::time_point pendingSince_;
    std::optional<core::Message> problem_;
};

}   // namespace angiopose::io
