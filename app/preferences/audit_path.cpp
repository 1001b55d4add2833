#include "app/preferences/audit_path.h"

#include "app/preferences/settings.h"
#include "io/sharing/audit_file.h"

namespace angiopose::app {

QString auditPath()
{
    const std::string forced = io::auditFileOfEnvironment();
    return forced.empty() ? settings::auditFile.read() : QString::fromStdString(forced);
}

}   // namespace angiopose::app
