#pragma once

#include <QString>

#include <vector>

namespace angiopose::ui {

/// An archive as the user enters it. Of keys and passwords only the paths of their files.
struct ArchiveEntry {
    QString name;   ///< by which the user calls it
    QString host;   ///< empty: DICOMweb only
    int port = 104;
    QString title = QStringLiteral("ANY-SCP");   ///< its AE title
    QString ownTitle = QStringLiteral("ANGIOPOSE");   ///< ours
    int receivePort = 0;   ///< 0: none
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
    bool checksHost = true;
    QString webUrl, authorizationFile;
    int answerSeconds = 9;
};

/// Who may push to our port, and how. Of keys only the paths of their files.
struct PortEntry {
    QString titles, hosts;   ///< that may call, with commas between them; empty: any
    bool isTls = false;
    QString caFile, certificateFile, keyFile;
};

/// What is looked for; what is empty is not asked about.
struct ArchiveSearch {
    QString patientName, patientId;
    QString from, to;   ///< of the study, as typed
    QString modality;
};

/// A study or series that an archive holds, in words.
struct MatchRow {
    QString key;
    QString what;   ///< the patient; of a series its number
    QString patientId;
    QString date;
    QString modality;
    QString description;
    int images = 0;   ///< 0: not told
};

}   // namespace angiopose::ui
