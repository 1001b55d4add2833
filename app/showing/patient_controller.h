#pragma once

#include "app/document/case_document.h"
#include "ui/panels/patient_bar.h"

#include <QAction>
#include <QObject>

namespace angiopose::app {

/// Shows the patient identity of the case's inputs above the case: several if they differ, and only that fact while the
/// identity is hidden.
class PatientController : public QObject {
    Q_OBJECT
public:
    PatientController(const CaseDocument& document, ui::PatientBar& bar, const QAction& hideIdentity,
                      QObject* parent = nullptr);

private:
    void show();

    const CaseDocument& document_;
    ui::PatientBar& bar_;
    const QAction& hideIdentity_;
};

}   // namespace angiopose::app
