#pragma once

#include <QCoreApplication>

namespace angiopose::app::report {

/// Translation context for the strings of the report.
struct PageWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::CaseReport)
};

}   // namespace angiopose::app::report
