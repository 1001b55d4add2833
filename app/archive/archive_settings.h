#pragma once

#include "app/preferences/settings.h"

/// What is remembered of archives beside their list; nothing of patients.
namespace angiopose::app::settings {

inline const Setting<QString> archiveNode{"archive/node", {}};   ///< the last one
inline const Setting<QString> archiveFrom{"archive/from", {}};   ///< of the last search, as typed
inline const Setting<QString> archiveTo{"archive/to", {}};
inline const Setting<QString> archiveModality{"archive/modality", {}};
inline const Setting<int> receivePort{"archive/receivePort", 11112};
inline const Setting<QString> receiveTitle{"archive/receiveTitle", QStringLiteral("ANGIOPOSE")};
inline const Setting<QString> receiveCallers{"archive/receiveCallers", {}};   ///< AE titles, as typed; empty: any
inline const Setting<QString> receiveHosts{"archive/receiveHosts", {}};   ///< addresses, as typed; empty: any
inline const Setting<bool> receiveTls{"archive/receiveTls", false};
inline const Setting<QString> receiveCertificate{"archive/receiveCertificate", {}};   ///< path; so the next two
inline const Setting<QString> receiveKey{"archive/receiveKey", {}};
inline const Setting<QString> receiveAuthorities{"archive/receiveAuthorities", {}};   ///< empty: the system's

}   // namespace angiopose::app::settings
