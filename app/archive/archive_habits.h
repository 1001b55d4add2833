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

}   // namespace angiopose::app::settings
