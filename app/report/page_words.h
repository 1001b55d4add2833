#pragma once

#include <QCoreApplication>

namespace angiopose::app::report {

/// The words of reports: one context for translators.
struct PageWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::CaseReport)
};

}   // namespace angiopose::app::report
