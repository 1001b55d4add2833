#pragma once

#include "app/editing/angiogram_parts.h"
#include "ui/words/retranslation.h"

#include <QObject>

namespace angiopose::app {

/// Applies the tracing options and shows the image regions that tracing excludes.
class CurveTracingController : public QObject {
    Q_OBJECT
public:
    explicit CurveTracingController(const AngiogramParts& parts, QObject* parent = nullptr);

private:
    void change(const core::TraceOptions& options, const ui::LocalizedText& undoText);
    void showExcludedRegions();

    CaseDocument& document_;
    TargetProvider& target_;
    ui::WindowActions& actions_;
    ui::AngiogramPanel& panel_;
    ui::AngiogramView& view_;
    SharedTrace shownTrace_;
};

}   // namespace angiopose::app
