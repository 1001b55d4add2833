#pragma once

#include <QDialog>
#include <QSize>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace angiopose::ui {

class NumberField;

enum class Toggle { Off, On };

enum class ImageFileFormat { Png, Svg, Pdf };
enum class ImageContent { Overlay, Frame, Frame16 };

/// Options of an overlay export.
struct OverlayExportOptions {
    int widthPx = 1024;
    Toggle residualColors = Toggle::On;
    Toggle identity = Toggle::Off;
    Toggle english = Toggle::Off;   ///< whether to use English labels even if the UI language is another
    Toggle cutout = Toggle::Off;   ///< whether to include the swipe or lens that is active in the window
    Toggle initialPose = Toggle::Off;   ///< whether to add a second image with the vessels at the initial pose
    ImageFileFormat format = ImageFileFormat::Png;
    ImageContent part = ImageContent::Overlay;   ///< Frame16 (16-bit gray values) requires PNG at native size
    int dotsPerInch = 300;
};

/// Asks for content, format, size and options of an overlay export. Emits `chosen` on Export.
class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// `viewWidthPx` is the current width of the view; `aspect` is the image height divided by its width.
    ExportDialog(int viewWidthPx, double aspect, QWidget* parent);

    void showOptions(const OverlayExportOptions& exportOptions);
    void offerCutout(bool hasCutout);   ///< initially checked if the window shows a swipe or lens
    OverlayExportOptions exportOptions() const;

signals:
    void chosen(const ui::OverlayExportOptions& exportOptions);

private:
    QFormLayout* makeForm();
    void showSize();
    void showPart();

    int viewWidthPx_;
    double aspect_;
    QComboBox* part_;
    QComboBox* format_;
    QComboBox* size_;
    NumberField* width_;
    QLabel* widthLabel_;
    NumberField* resolution_;
    QLabel* outputSize_;
    QCheckBox* residuals_;
    QCheckBox* identity_;
    QCheckBox* english_;
    QCheckBox* cutout_;
    QCheckBox* withInitialPose_;
};

/// DICOM objects that can be exported, in the order of the check boxes.
enum class DicomPart { Picture, Run, Report, State, Registration, Segmentation, Measurements };

struct DicomExportOptions {
    std::vector<DicomPart> parts;
    Toggle identity = Toggle::Off;   ///< whether to burn the patient identity into images and report
};

enum class DicomPurpose { Export, Send };

/// Dialog that selects the DICOM objects to create from a case; objects that the case cannot provide are disabled.
/// Emits `chosen` on Export or Send.
class DicomDialog : public QDialog {
    Q_OBJECT
public:
    /// Enables and initially checks the objects in `possible`.
    DicomDialog(const std::vector<DicomPart>& possible, DicomPurpose purpose, QWidget* parent);

    DicomExportOptions exportOptions() const;

signals:
    void chosen(const ui::DicomExportOptions& exportOptions);

private:
    void showState();

    std::vector<QCheckBox*> boxes_;   ///< one per object, in the order of DicomPart
    QCheckBox* identity_;
    QPushButton* export_;
};

}   // namespace angiopose::ui
