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
    std::vector<std::string> paths;   ///< files and folders that it is about
    std::string archive{};   ///< with which they were exchanged; may be empty
};

/// Adds a line of JSON to the audit file (FORMATS §4): time in UTC, account, program and version, event, and the
/// SHA-256 of every file, of a folder those of the files in it. Reads them whole. Fails where the line cannot be
/// written.
core::Status recordAudit(const std::string& auditPath, const AuditRecord& record);

/// The file that `ANGIOPOSE_AUDIT_FILE` names; empty: none.
std::string auditFileOfEnvironment();

/// Files that come one after another, noted in the audit file many to a line, soon after they came. Without a path of
/// that file nothing is noted.
class AuditBatch {
public:
    AuditBatch(std::string auditPath, AuditRecord about);

    void add(const std::string& path);
    /// To be called again and again: a line where many wait, or the first one has waited.
    void noteWhenDue();
    void noteAll();

    /// Why the last line could not be written; nothing where all were.
    const std::optional<core::Message>& problem() const { return problem_; }

private:
    std::string auditPath_;
    AuditRecord record_;
    std::chrono::steady_clock::time_point waitsSince_;
    std::optional<core::Message> problem_;
};

}   // namespace angiopose::io
