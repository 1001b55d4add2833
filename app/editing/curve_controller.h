#pragma once

#include "app/editing/angiogram_parts.h"
#include "ui/views/tools/edit_curves_tool.h"

#include <QFutureWatcher>
#include <QObject>

#include <memory>
#include <optional>

namespace angiopose::ui {
class CurveEditBar;
}

namespace angiopose::app {

/// Lets the user edit the traced curves on the angiogram and mark catheters and guidewires, which are excluded. Edited
/// curves are the target of their frame until it is traced again; each edit is one undo step.
class CurveController : public QObject {
    Q_OBJECT
public:
    explicit CurveController(const AngiogramParts& parts, QObject* parent = nullptr);

    ui::EditCurvesTool& tool() { return *tool_; }
    void confirmRetrace();

private:
    void connectTool();
    void updateFromDocument();
    void showCurves();
    void requestEdgeData();
    void releaseEdgeData();   ///< frees the edge data of the tool, which also keep the angiogram in memory
    std::vector<int> suspects() const;
    std::vector<int> acceptedIds() const;
    void applyEdit(const core::Centerline2d& curves, const ui::LocalizedText& undoText);
    void accept(int curveId);
    void setExcluded(int curveId, bool isExcluded);
    void trackDevice();
    void push(core::GivenTarget target,
              const ui::LocalizedText& undoText);   ///< sets the target edited in the shown frame as that of the case
    core::SeparatedCurves currentCurves() const;
    void retrace();

    CaseDocument& document_;
    TargetProvider& target_;
    ui::WindowActions& actions_;
    ui::AngiogramPanel& panel_;
    ui::AngiogramView& view_;
    QWidget& dialogParent_;
    Notifications& notifications_;
    ui::EditCurvesTool* tool_;
    ui::CurveEditBar* bar_;
    SharedCenterline shownCurves_;
    SharedCenterline shownDevices_;
    std::vector<int> shownAccepted_;
    std::optional<TraceRequest> edgeDataRequest_;   ///< request whose edge data are available or are being computed
    QFutureWatcher<std::shared_ptr<ui::CurveGuide>> edgeData_;
};

}   // namespace angiopose::app
