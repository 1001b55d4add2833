#include "io/sharing/audit_batch.h"

#include <utility>

namespace angiopose::io {
namespace {

constexpr std::size_t mostWaiting = 200;
constexpr std::chrono::seconds longestWait{2};   // what a killed program may leave out

}   // namespace

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
        waitsSince_ = std::chrono::steady_clock::now();
    }
    record_.paths.push_back(path);
}

void AuditBatch::noteWhenDue()
{
    const bool hasWaited = std::chrono::steady_clock::now() - waitsSince_ >= longestWait;
    if (record_.paths.size() >= mostWaiting || (!record_.paths.empty() && hasWaited)) {
        noteAll();
    }
}

void AuditBatch::noteAll()
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
