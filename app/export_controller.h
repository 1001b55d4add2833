#pragma once

#include "app/case_document.h"
#include "app/target_provider.h"
#include "ui/dialogs/export_dialog.h"

#include <QObject>

namespace ui {
class MainWindow;
}

namespace app {

/// Writes what leaves the program: overlay picture, result, pose, traced vessels.
class ExportController : public QObject {
    Q_OBJECT
public:
    ExportController(CaseDocument& document, TargetProvider& target, ui::MainWindow& window, QObject* parent = nullptr);

    void askOverlay();
    core::Status writeOverlay(const ui::ExportChoice& choice, const QString& path) const;
    void askResult();
    void askPose();
    void askTrace();

signals:
    void exported(const QString& path);
    void failed(const QString& reason);

private:
    struct FileQuestion {
        QString title;
        QString filter;
        QString suffix;   ///< also the end of the suggested name
    };
    template <class Write>
    void askFile(const FileQuestion& question, const Write& write);

    CaseDocument& document_;
    TargetProvider& target_;
    ui::MainWindow& window_;
};

}   // namespace app
