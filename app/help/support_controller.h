#pragma once

#include "app/document/case_document.h"
#include "app/jobs/job.h"
#include "io/sharing/redaction.h"
#include "io/sharing/support_bundle.h"

#include <QDateTime>
#include <QObject>
#include <QStringList>

#include <memory>
#include <vector>

class QWidget;

namespace angiopose::ui {
class BottomStrip;
class FaultBar;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

using SharedTexts = std::shared_ptr<const std::vector<io::SupportFile>>;

/// Creates support bundles: collects diagnostic data about the program, removes the identity of all patients of the
/// session, shows the result and writes it to a file that the user chooses. Also reports the crash of the last session.
class SupportController : public QObject {
    Q_OBJECT
public:
    /// Parts of the main window that the controller uses.
    struct Ui {
        ui::WindowActions& actions;
        ui::BottomStrip& strip;
        ui::FaultBar& faults;
        QWidget& dialogParent;
    };
    SupportController(const CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void reportCrash();   ///< reports each crash once only

signals:
    void written(const QString& path);
    void failed(const QString& reason);

private:
    void rememberCase();
    void collect();
    void show(const SharedTexts& texts);
    void askForPath(const SharedTexts& texts);
    void write(const SharedTexts& texts, const QString& path);
    std::string logText() const;

    const CaseDocument& document_;
    Ui ui_;
    QDateTime sessionStart_ = QDateTime::currentDateTime();
    io::Redaction redaction_;   ///< contains the identifiers of every case of this session
    QStringList inputs_;   ///< input files of all cases of this session
    QStringList latestInputs_;
    Job<SharedTexts> collectJob_;
    Job<QString> writeJob_;
};

}   // namespace angiopose::app
