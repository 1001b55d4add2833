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

using SharedTexts = std::shared_ptr<const std::vector<io::SupportText>>;

/// The support bundle: put together from what the program knows of itself, freed of whom the cases of the session are
/// of, shown, and written where the user says. Tells of the fault that ended the last session.
class SupportController : public QObject {
    Q_OBJECT
public:
    /// What of the window it serves.
    struct Ui {
        ui::WindowActions& actions;
        ui::BottomStrip& strip;
        ui::FaultBar& faults;
        QWidget& dialogParent;
    };
    SupportController(const CaseDocument& document, const Ui& ui, QObject* parent = nullptr);

    void tellOfFault();   ///< once for each

signals:
    void written(const QString& path);
    void failed(const QString& reason);

private:
    void rememberCase();
    void prepare();
    void show(const SharedTexts& texts);
    void askPath(const SharedTexts& texts);
    void write(const SharedTexts& texts, const QString& path);
    std::string logText() const;

    const CaseDocument& document_;
    Ui ui_;
    QDateTime begun_ = QDateTime::currentDateTime();
    io::Redaction redaction_;   ///< knows every case of this session
    QStringList inputs_;   ///< of all of them
    QStringList newest_;
    Job<SharedTexts> texts_;
    Job<QString> writing_;
};

}   // namespace angiopose::app
