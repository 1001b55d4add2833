#include "ui/dialogs/dicom_dialog.h"

#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"

#include <QCheckBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace angiopose::ui {

DicomDialog::DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent)
    : QDialog(parent),
      boxes_{new QCheckBox(tr("Picture of the overlay (Secondary Capture)")),
             new QCheckBox(tr("Pictures of the run (Secondary Capture)")),
             new QCheckBox(tr("Report (PDF)")),
             new QCheckBox(tr("Vessels as lines on the stored image (Presentation State)")),
             new QCheckBox(tr("Pose (Spatial Registration)")),
             new QCheckBox(tr("Vessels in the scan (Segmentation)")),
             new QCheckBox(tr("Measurements (Structured Report)"))},
      identity_(new QCheckBox(tr("Patient identity in pictures and report"))),
      export_(new QPushButton(purpose == DicomPurpose::Send ? tr("Choose archive …") : tr("Export …")))
{
    setObjectName(QStringLiteral("dicomDialog"));
    setWindowTitle(purpose == DicomPurpose::Send ? tr("Send to archive") : tr("Export DICOM objects"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(460);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(10);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const bool isPossible = std::ranges::find(possible, static_cast<DicomPart>(i)) != possible.end();
        boxes_[i]->setEnabled(isPossible);
        boxes_[i]->setChecked(isPossible);
        layout->addWidget(boxes_[i]);
        connect(boxes_[i], &QCheckBox::toggled, this, &DicomDialog::showState);
    }
    auto* rigid = roleLabel(
        "hint", purpose == DicomPurpose::Send
                    ? tr("A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, which "
                         "stands in its private elements. The file camera.json is not sent.")
                    : tr("A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, "
                         "which is written beside it as camera.json."));
    auto* passedOn = roleLabel("hint", tr("Every object names the patient in its header, as its image does, whatever "
                                          "its pictures show. Each is a new instance in the study of its image."));
    layout->addSpacing(8);
    layout->addWidget(identity_);
    for (QLabel* hint : {rigid, passedOn}) {
        hint->setWordWrap(true);
        layout->addWidget(hint);
    }
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *export_));
    connect(this, &QDialog::accepted, this, [this] { emit chosen(this->choice()); });
    showState();
}

void DicomDialog::showState()
{
    export_->setEnabled(std::ranges::any_of(boxes_, [](const QCheckBox* box) { return box->isChecked(); }));
}

DicomChoice DicomDialog::choice() const
{
    DicomChoice choice;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (boxes_[i]->isChecked()) {
            choice.parts.push_back(static_cast<DicomPart>(i));
        }
    }
    choice.identity = identity_->isChecked() ? Choice::On : Choice::Off;
    return choice;
}

}   // namespace angiopose::ui
