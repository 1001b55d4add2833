#pragma once

#include <QWidget>

class QLabel;

namespace angiopose::ui {

class ElidedLabel;

/// Whom the case is of, in a line.
struct PatientLine {
    QString doubt;   ///< what is wrong with it, before everything else; empty: nothing
    QString name;
    QString details;   ///< number, birth date, sex and the inputs that say so
};

/// The line over the case that says whose inputs it holds; hidden while they say nothing.
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
