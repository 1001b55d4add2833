#pragma once

#include <QString>

#include <vector>

namespace angiopose::ui {

/// Archive settings as entered by the user. Keys and passwords are stored only as file paths.
struct ArchiveEntry {
    QString name;   ///< display name chosen by the user
    QString host;   ///< empty: DICOMweb only
    int port = 104;
    QString title = QStringLiteral("ANY-SCP");   ///< called AE title
    QString ownTitle = QStringLiteral("ANGIOPOSE");   ///< calling AE title
    int receivePort = 0;   ///< 0: none
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
    bool checksHost = true;
    QString webUrl, authorizationFile;
    int answerSeconds = 9;
};

/// Allowed senders of the storage SCP and its TLS settings. Keys are stored only as file paths.
struct PortEntry {
    QString titles, hosts;   ///< allowed callers, comma-separated; empty: any
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
};

/// Search criteria; empty fields are not part of the query.
struct ArchiveSearch {
    QString patientName, patientId;
    QString from, to;   ///< study dates, as typed
    QString modality;
};

/// Display texts of a study or series found in an archive.
struct MatchRow {
    QString key;
    QString what;   ///< patient of a study, or number of a series
    QString patientId;
    QString date;
    QString modality;
    QString description;
    int images = 0;   ///< 0: not reported
};

}   // namespace angiopose::ui
