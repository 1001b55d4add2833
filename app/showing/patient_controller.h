#pragma once

#include "app/document/case_document.h"
#include "ui/panels/patient_bar.h"

#include <QAction>
#include <QObject>

namespace angiopose::app {

/// Says over the case whom its inputs are of, all of them: several where they differ, nothing but that while the
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
