#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace angiopose::ui {

/// One series of a study, in words.
struct StudySeriesRow {
    enum class Use { Vessels, View, None };

    QString key;   ///< tells it from all others, and stays while more is found
    Use use = Use::None;
    int number = 0;
    QString modality;
    QString description;
    int imageCount = 0;
    QString size;   ///< "512 × 512"
    QString pace;   ///< distance of slices, or frames in a second
    double paceValue = 0.0;   ///< by which it is sorted
    QString bodyPart;
    QStringList notes;   ///< why it cannot be opened, what is missing, warnings
};

struct StudyRow {
    QString key;
    QString words;   ///< date, description, accession
    std::vector<StudySeriesRow> series;
};

struct PatientRow {
    QString key;
    QString words;   ///< name, ID, birth date; or nothing of these
    std::vector<StudyRow> studies;
};

}   // namespace angiopose::ui
