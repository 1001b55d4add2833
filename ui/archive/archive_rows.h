#pragma once

#include <QString>

#include <vector>

namespace angiopose::ui {

/// PACS settings as entered by the user. For keys and passwords, only file paths are stored.
struct ArchiveEntry {
    QString name;   ///< display name chosen by the user
    QString host;   ///< empty if the node supports DICOMweb only
    int port = 104;
    QString title = QStringLiteral("ANY-SCP");   ///< called AE title
    QString ownAeTitle = QStringLiteral("ANGIOPOSE");   ///< calling AE title
    int receivePort = 0;   ///< port for C-MOVE; 0 if none
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
    bool verifiesHost = true;
    QString webUrl, authorizationFile;
    int responseTimeoutSeconds = 9;
};

/// Allowed senders and TLS settings of the storage SCP. For keys, only file paths are stored.
struct ScpSettings {
    QString titles, hosts;   ///< allowed calling AE titles and hosts, comma-separated; empty allows any
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
};

/// Search criteria; empty fields do not restrict the query.
struct ArchiveSearch {
    QString patientName, patientId;
    QString from, to;   ///< study dates, as typed
    QString modality;
};

/// One study or series found in an archive, as displayed in the list.
struct MatchRow {
    QString key;
    QString what;   ///< patient of the study, or number of the series
    QString patientId;
    QString date;
    QString modality;
    QString description;
    int images = 0;   ///< 0 if not reported by the archive
};

}   // namespace angiopose::ui
