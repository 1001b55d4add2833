#pragma once

#include "app/document/case_document.h"
#include "app/jobs/file_queue.h"
#include "app/registration/target_provider.h"
#include "app/showing/pose_preview.h"
#include "app/texts/overlay_picture.h"
#include "ui/dialogs/export_dialog.h"

#include <QObject>

#include <functional>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Writes what leaves the program: overlay picture, result, pose, traced vessels.
class ExportController : public QObject {
    Q_OBJECT
public:
    ExportController(CaseDocument& document, TargetProvider& target, const PosePreview& preview,
                     ui::AngiogramView& view, QWidget& dialogParent, QObject* parent = nullptr);

    struct FileQuestion {
        QString title;
        QString filter;
        QString suffix;   ///< also the end of the suggested name
        bool isOfCase = true;   ///< else written beside it, as a template
    };
    /// Writes one file on a worker; gets all it needs by value.
    using Write = std::function<core::Status(const QString& path)>;
    using Then = std::function<void()>;   ///< called once it is written
    void askFile(const FileQuestion& question, const Write& write, const Then& then = {});
    void askPath(const FileQuestion& question, const std::function<void(const QString& path)>& use);
    void writeFile(const QString& path, const Write& write, const Then& then = {});   ///< of the case; returns at once

    void askOverlay();
    OverlayPictureOptions lookOf(const ui::ExportChoice& choice) const;   ///< as the window shows it
    void exportOverlay(const ui::ExportChoice& choice, const QString& path);   ///< returns at once
    void askResult();
    void askPose();
    void askTrace();
    void askMeasurements();
    void askCheckPoints();
    void askMask();   ///< the lumen as a label image
    void askVessels(const Then& then = {});
    void askDeformed();   ///< the tree as it is bent, or how each of its points moved

signals:
    void started();
    void written(const QString& path);
    void exported();   ///< what was written is of the case
    void failed(const QString& reason);

private:
    static FileQuestion questionFor(ui::PictureFormat format);
    Write overlayWriter(const ui::ExportChoice& choice) const;
    void run(const QString& path, const Write& write, const Then& then, bool isOfCase);

    CaseDocument& document_;
    TargetProvider& target_;
    const PosePreview& preview_;   ///< which vessels pictures show
    ui::AngiogramView& view_;
    QWidget& dialogParent_;
    FileQueue files_;
};

}   // namespace angiopose::app