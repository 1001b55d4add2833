#pragma once

#include "app/document/case_document.h"
#include "ui/panels/patient_bar.h"

#include <QAction>
#include <QObject>

namespace angiopose::app {

/// Shows the patient identity found in the case's inputs above the case. If the inputs name several patients, shows all
/// of them or, if the identity is hidden, only the fact that they differ.
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
