#pragma once

#include <QWidget>

class QLabel;

namespace angiopose::ui {

class ElidedLabel;

/// Patient identity of the case, in one line.
struct PatientLine {
    QString doubt;   ///< identity problem, shown first; empty: none
    QString name;
    QString details;   ///< ID, birth date, sex and the inputs they come from
};

/// Bar above the case with the patient of the inputs; hidden if the inputs do not identify a patient.
class PatientBar : public QWidget {
    Q_OBJECT
public:
    explicit PatientBar(QWidget* parent = nullptr);

    void showPatient(const PatientLine& line);

private:
    QLabel* doubt_;
    QLabel* name_;
    ElidedLabel* details_;
};

}   // namespace angiopose::ui
