#include "ui/dialogs/export_dialog.h"

#include "ui/controls/number_field.h"
#include "ui/controls/section.h"
#include "ui/dialogs/dialog_buttons.h"
#include "ui/words/language.h"
#include "ui/words/number.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace angiopose::ui {
namespace {

enum SizeEntry { ViewSize, Size1024, Size2048, CustomSize };

}   // namespace

ExportDialog::ExportDialog(int viewWidthPx, double aspect, QWidget* parent)
    : QDialog(parent),
      viewWidthPx_(viewWidthPx),
      aspect_(aspect),
      part_(new QComboBox),
      format_(new QComboBox),
      size_(new QComboBox),
      width_(new NumberField({64.0, 8192.0, 0, QStringLiteral("px"), 64.0})),
      widthLabel_(roleLabel("label", tr("Width"))),
      resolution_(new NumberField({10.0, 4800.0, 0, tr("dpi"), 50.0})),
      outputSize_(roleLabel("hint")),
      residuals_(new QCheckBox(tr("Residual colors with scale"))),
      identity_(new QCheckBox(tr("Burn in patient identity"))),
      english_(new QCheckBox(tr("English labels"))),
      cutout_(new QCheckBox(tr("Swipe or lens as in the window"))),
      withInitialPose_(new QCheckBox(tr("Side by side with initial pose")))
{
    setObjectName(QStringLiteral("exportDialog"));
    setWindowTitle(tr("Export overlay"));
    setAttribute(Qt::WA_DeleteOnClose);
    setMinimumWidth(400);
    size_->addItems({tr("As in the window"), tr("1024 px wide"), tr("2048 px wide"), tr("Other width")});
    width_->showValue(1600.0);
    part_->setObjectName(QStringLiteral("exportPart"));
    part_->addItems({tr("Vessels over the image"), tr("Image only"), tr("16-bit gray values of the image")});
    format_->setObjectName(QStringLiteral("exportFormat"));
    format_->addItems({tr("PNG (raster)"), tr("SVG (vector)"), tr("PDF (vector)")});

    auto* notice =
        roleLabel("hint", tr("The image is labeled “Not for clinical use”; inputs, method and pose are stored in its "
                             "metadata (16-bit images carry the label in the metadata only)."));
    notice->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(22, 20, 22, 16);
    layout->setSpacing(14);
    layout->addLayout(makeForm());
    layout->addWidget(notice);
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *new QPushButton(tr("Export…"))));
    connect(size_, &QComboBox::currentIndexChanged, this, &ExportDialog::showSize);
    connect(part_, &QComboBox::currentIndexChanged, this, &ExportDialog::showPart);
    connect(resolution_, &NumberField::edited, this, &ExportDialog::showSize);
    connect(width_, &NumberField::edited, this, &ExportDialog::showSize);
    connect(this, &QDialog::accepted, this, [this] { emit chosen(exportOptions()); });
    connect(withInitialPose_, &QCheckBox::toggled, this, &ExportDialog::showSize);
    offerCutout(false);
    showOptions({});
}

QFormLayout* ExportDialog::makeForm()
{
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    form->addRow(roleLabel("label", tr("Contents")), part_);
    form->addRow(roleLabel("label", tr("Format")), format_);
    form->addRow(roleLabel("label", tr("Size")), size_);
    form->addRow(widthLabel_, width_);
    form->addRow(roleLabel("label", tr("Print resolution")), resolution_);
    for (QWidget* line :
         std::initializer_list<QWidget*>{outputSize_, residuals_, withInitialPose_, cutout_, identity_, english_}) {
        form->addRow(QString(), line);
    }
    english_->setVisible(currentLanguage() != languages().front());
    return form;
}

void ExportDialog::offerCutout(bool hasCutout)
{
    cutout_->setChecked(hasCutout);
    cutout_->setVisible(hasCutout);
}

void ExportDialog::showOptions(const OverlayExportOptions& exportOptions)
{
    const int entry = exportOptions.widthPx == 1024 ? Size1024 : exportOptions.widthPx == 2048 ? Size2048 : CustomSize;
    size_->setCurrentIndex(exportOptions.widthPx == viewWidthPx_ ? ViewSize : entry);
    if (entry == CustomSize) {
        width_->showValue(exportOptions.widthPx);
    }
    residuals_->setChecked(exportOptions.residualColors == Toggle::On);
    identity_->setChecked(exportOptions.identity == Toggle::On);
    english_->setChecked(exportOptions.english == Toggle::On);
    format_->setCurrentIndex(static_cast<int>(exportOptions.format));
    part_->setCurrentIndex(static_cast<int>(exportOptions.part));
    resolution_->showValue(exportOptions.dotsPerInch);
    showPart();
}

OverlayExportOptions ExportDialog::exportOptions() const
{
    OverlayExportOptions result;
    switch (size_->currentIndex()) {
        case ViewSize:
            result.widthPx = viewWidthPx_;
            break;
        case Size1024:
            result.widthPx = 1024;
            break;
        case Size2048:
            result.widthPx = 2048;
            break;
        default:
            result.widthPx = static_cast<int>(width_->value().value_or(1024.0));
    }
    result.residualColors = residuals_->isChecked() ? Toggle::On : Toggle::Off;
    result.identity = identity_->isChecked() ? Toggle::On : Toggle::Off;
    result.english = english_->isChecked() ? Toggle::On : Toggle::Off;
    result.cutout = cutout_->isChecked() ? Toggle::On : Toggle::Off;
    result.initialPose = withInitialPose_->isChecked() ? Toggle::On : Toggle::Off;
    result.part = static_cast<ImageContent>(part_->currentIndex());
    result.format = result.part == ImageContent::Frame16 ? ImageFileFormat::Png
                                                         : static_cast<ImageFileFormat>(format_->currentIndex());
    result.dotsPerInch = static_cast<int>(resolution_->value().value_or(300.0));
    return result;
}

/// Disables options that do not apply to the selected content.
void ExportDialog::showPart()
{
    const auto part = static_cast<ImageContent>(part_->currentIndex());
    for (QWidget* ofVessels : std::initializer_list<QWidget*>{residuals_, withInitialPose_, cutout_}) {
        ofVessels->setEnabled(part == ImageContent::Overlay);
    }
    for (QWidget* ofSeen : std::initializer_list<QWidget*>{format_, size_, width_, identity_, english_}) {
        ofSeen->setEnabled(part != ImageContent::Frame16);
    }
    showSize();
}

void ExportDialog::showSize()
{
    const bool isCustom = size_->currentIndex() == CustomSize;
    width_->setVisible(isCustom);
    widthLabel_->setVisible(isCustom);
    const OverlayExportOptions options = exportOptions();
    if (options.part == ImageContent::Frame16) {
        outputSize_->setText(tr("same size as the frame"));
        return;
    }
    const double cmPerPx = 2.54 / options.dotsPerInch;
    const QString size =
        tr("%1 × %2 px, %3 × %4 cm")
            .arg(options.widthPx)
            .arg(std::lround(options.widthPx * aspect_))
            .arg(numberText(cmPerPx * options.widthPx, 1), numberText(cmPerPx * options.widthPx * aspect_, 1));
    const bool hasTwoImages = withInitialPose_->isChecked() && options.part == ImageContent::Overlay;
    outputSize_->setText(hasTwoImages ? tr("two images, %1 each").arg(size) : size);
}

DicomDialog::DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent)
    : QDialog(parent),
      boxes_{new QCheckBox(tr("Overlay image (Secondary Capture)")),
             new QCheckBox(tr("Images of the run (Secondary Capture)")),
             new QCheckBox(tr("Report (PDF)")),
             new QCheckBox(tr("Vessels as lines on the stored image (Presentation State)")),
             new QCheckBox(tr("Pose (Spatial Registration)")),
             new QCheckBox(tr("Vessels in the scan (Segmentation)")),
             new QCheckBox(tr("Measurements (Structured Report)"))},
      identity_(new QCheckBox(tr("Patient identity in images and report"))),
      export_(new QPushButton(purpose == DicomPurpose::Send ? tr("Choose PACS…") : tr("Export…")))
{
    setObjectName(QStringLiteral("dicomDialog"));
    setWindowTitle(purpose == DicomPurpose::Send ? tr("Send to PACS") : tr("Export DICOM objects"));
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
    auto* rigid = roleLabel("hint", purpose == DicomPurpose::Send
                                        ? tr("A Spatial Registration contains only a rigid matrix. The perspective "
                                             "camera is stored in private elements. The file camera.json is not sent.")
                                        : tr("A Spatial Registration contains only a rigid matrix. The perspective "
                                             "camera is written to camera.json in the same folder."));
    auto* passedOn = roleLabel("hint", tr("DICOM headers contain the patient's identity even if the images do not show "
                                          "it. Each object is a new instance in the study of its image."));
    layout->addSpacing(8);
    layout->addWidget(identity_);
    for (QLabel* hint : {rigid, passedOn}) {
        hint->setWordWrap(true);
        layout->addWidget(hint);
    }
    layout->addLayout(dialogButtons(*this, tr("Cancel"), *export_));
    connect(this, &QDialog::accepted, this, [this] { emit chosen(this->exportOptions()); });
    showState();
}

void DicomDialog::showState()
{
    export_->setEnabled(std::ranges::any_of(boxes_, [](const QCheckBox* box) { return box->isChecked(); }));
}

DicomExportOptions DicomDialog::exportOptions() const
{
    DicomExportOptions exportOptions;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (boxes_[i]->isChecked()) {
            exportOptions.parts.push_back(static_cast<DicomPart>(i));
        }
    }
    exportOptions.identity = identity_->isChecked() ? Toggle::On : Toggle::Off;
    return exportOptions;
}

}   // namespace angiopose::ui
