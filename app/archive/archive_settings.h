#pragma once

#include "app/preferences/settings.h"

/// Archive settings stored in addition to the list of archives; they contain no patient data.
namespace angiopose::app::settings {

inline const Setting<QString> archiveNode{"archive/node", {}};   ///< last selected archive
inline const Setting<QString> archiveFrom{"archive/from", {}};   ///< start date of the last search, as typed
inline const Setting<QString> archiveTo{"archive/to", {}};
inline const Setting<QString> archiveModality{"archive/modality", {}};
inline const Setting<int> receivePort{"archive/receivePort", 11112};
inline const Setting<QString> receiveTitle{"archive/receiveTitle", QStringLiteral("ANGIOPOSE")};
inline const Setting<QString> receiveCallers{"archive/receiveCallers",
                                             {}};   ///< accepted calling AE titles, as typed; empty: any
inline const Setting<QString> receiveHosts{"archive/receiveHosts", {}};   ///< accepted addresses, as typed; empty: any
inline const Setting<bool> receiveTls{"archive/receiveTls", false};
inline const Setting<QString> receiveCertificate{"archive/receiveCertificate",
                                                 {}};   ///< file path, like the next two settings
inline const Setting<QString> receiveKey{"archive/receiveKey", {}};
inline const Setting<QString> receiveAuthorities{"archive/receiveAuthorities",
                                                 {}};   ///< if empty, the certificate authorities of the system

}   // namespace angiopose::app::settings
