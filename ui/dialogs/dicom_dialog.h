#pragma once

#include "ui/dialogs/export_dialog.h"

#include <vector>

class QPushButton;

namespace angiopose::ui {

/// What the user wants to have as DICOM objects, in the order of the boxes.
enum class DicomPart { Picture, Run, Report, State, Registration, Segmentation, Measurements };

struct DicomChoice {
    std::vector<DicomPart> parts;
    Choice identity = Choice::Off;   ///< burned into pictures and report
};

enum class DicomPurpose { Export, Send };

/// Asks which DICOM objects are made of a case. What the case does not allow cannot be chosen. `chosen` follows on
/// Export, or on the way to an archive.
class DicomDialog : public QDialog {
    Q_OBJECT
public:
    /// `possible` can be chosen, and is at first.
    DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent);

    DicomChoice choice() const;

signals:
    void chosen(const ui::DicomChoice& choice);

private:
    void showState();

    std::vector<QCheckBox*> boxes_;   ///< one for each part
    QCheckBox* identity_;
    QPushButton* export_;
};

}   // namespace angiopose::ui
