#pragma once

#include <QWidget>

class QLabel;

namespace angiopose::ui {

class ElidedLabel;

/// Parts of the patient bar, which are shown in one line.
struct PatientText {
    QString warning;   ///< problem with the patient identity, shown first; empty if none
    QString name;
    QString details;   ///< ID, birth date and sex, and the inputs that state them
};

/// Bar above the views with the patient identity stated by the inputs; hidden if the inputs state none.
class PatientBar : public QWidget {
    Q_OBJECT
public:
    explicit PatientBar(QWidget* parent = nullptr);

    void showPatient(const PatientText& line);

private:
    QLabel* warning_;
    QLabel* name_;
    ElidedLabel* details_;
};

}   // namespace angiopose::ui
