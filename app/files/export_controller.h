#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "app/registration/target_provider.h"
#include "app/showing/pose_preview.h"
#include "app/texts/overlay_image.h"
#include "ui/dialogs/export_dialog.h"

#include <QObject>

#include <functional>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Exports files, e.g. the overlay image, the result, the pose and the traced vessels.
class ExportController : public QObject {
    Q_OBJECT
public:
    ExportController(CaseDocument& document, TargetProvider& target, const PosePreview& preview,
                     ui::AngiogramView& view, QWidget& dialogParent, QObject* parent = nullptr);

    struct FileQuestion {
        QString title;
        QString filter;
        QString suffix;   ///< file extension, also the ending of the suggested name
        bool isOfCase = true;   ///< false for other files, e.g. report templates
    };
    /// Writes one file on a worker thread; holds copies of all its data.
    using Write = std::function<core::Status(const QString& path)>;
    using Continuation = std::function<void()>;   ///< called after the file is written
    void askForFile(const FileQuestion& question, const Write& write, const Continuation& then = {});
    void askForPath(const FileQuestion& question, const std::function<void(const QString& path)>& use);
    void writeFile(const QString& path, const Write& write,
                   const Continuation& then = {});   ///< writes a file with data of the case; returns at once

    void openOverlayDialog();
    OverlayImageOptions overlayOptions(
        const ui::OverlayExportOptions& exportOptions) const;   ///< appearance as in the window
    void exportOverlay(const ui::OverlayExportOptions& exportOptions, const QString& path);   ///< returns at once
    void askForResultFile();
    void askForPoseFile();
    void askForTraceFile();
    void askForMeasurementFile();
    void askForTargetPointFile();
    void askForMaskFile();   ///< exports the lumen as a label image
    void askForVesselFile(const Continuation& then = {});
    void askForDeformedFile();   ///< exports the deformed tree or the displacement of each of its points

signals:
    void started();
    void written(const QString& path);
    void exported();   ///< emitted when data of the case were exported
    void failed(const QString& reason);

private:
    static FileQuestion questionFor(ui::ImageFileFormat format);
    Write overlayWriter(const ui::OverlayExportOptions& exportOptions) const;
    void run(const QString& path, const Write& write, const Continuation& then, bool isOfCase);

    CaseDocument& document_;
    TargetProvider& target_;
    const PosePreview& preview_;   ///< determines the vessels that exported images show
    ui::AngiogramView& view_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app
