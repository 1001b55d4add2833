#pragma once

#include "io/sharing/audit_file.h"

#include <chrono>
#include <optional>
#include <string>

namespace angiopose::io {

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
