#pragma once

#include "ui/dialogs/export_dialog.h"

#include <QString>

class QLineEdit;

namespace angiopose::ui {

struct PackChoice {
    Choice identity = Choice::Off;   ///< whether it goes with the case
    Choice shiftedDates = Choice::Off;   ///< instead of none
    Choice blackedOut = Choice::Off;   ///< letters that are drawn into the pictures
    QString pseudonym;   ///< empty: made up
};

/// Asks how a case is packed: without identity unless that is wished. `chosen` follows on Pack.
class PackDialog : public QDialog {
    Q_OBJECT
public:
    explicit PackDialog(QWidget* parent);

    PackChoice choice() const;

signals:
    void chosen(const ui::PackChoice& choice);

private:
    QCheckBox* nameless_;
    QCheckBox* shiftedDates_;
    QCheckBox* blackedOut_;
    QLineEdit* pseudonym_;
};

}   // namespace angiopose::ui
