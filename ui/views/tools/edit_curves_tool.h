#pragma once

#include "core/tracing/angiogram/drawing/live_wire.h"
#include "core/vessel/centerline2d.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/views/image_tool.h"
#include "ui/views/tools/curve_strokes.h"
#include "ui/views/tools/wire_path.h"
#include "ui/words/retranslation.h"

#include <memory>
#include <vector>

namespace angiopose::ui {

enum class CurveEdit { Erase, Draw, Cut, Remove, MarkDevice, Box, Lasso };

/// IDs of the curves that are or may be devices.
struct CurveMarks {
    std::vector<int> suspects = {};   ///< possible catheters, guidewires or bone edges
    std::vector<int> devices = {};   ///< catheters or guidewires confirmed by the user
};

/// Image features that the live wire follows and on which drawn curves are centered.
struct CurveGuide {
    core::LiveWire liveWire;
    core::ImageF opacity;
    double maxRadiusPx = 8.0;
};

/// Tool for editing the traced curves of the frame with the mouse; see `CurveEdit`. Possible devices are dashed amber,
/// with a check mark, a wire and a cross to click; S selects the next one, A accepts it as a vessel, W marks it as a
/// catheter or guidewire, Delete removes it. Confirmed devices are dashed white. Emits the resulting curves after each
/// edit.
class EditCurvesTool : public ImageTool {
    Q_OBJECT
public:
    explicit EditCurvesTool(AngiogramView& view);
    ~EditCurvesTool() override;

    void showCurves(const core::Centerline2d& curves, CurveMarks marks);   ///< cancels the current edit
    void setReady(bool ready);   ///< if false, disables editing while the frame is being traced
    void setGuide(std::shared_ptr<CurveGuide> guide);   ///< null if not available yet, so that drawn lines are straight
    bool hasGuide() const { return guide_ != nullptr; }
    void setEdit(CurveEdit edit);
    CurveEdit edit() const { return edit_; }
    void setBrush(double radius);   ///< radius in widget px
    double brush() const { return brushRadius_; }

    QString caption() const override;
    void begin() override;
    void end() override;
    bool startDrag(const ToolPoint& pressed) override;
    void drag(const ToolPoint& point) override;
    void finishDrag(const ToolPoint& point) override;
    void cancelDrag() override;
    bool click(const ToolPoint& point) override;
    bool doubleClick(const ToolPoint& point) override;
    void hover(const ToolPoint& point) override;
    void leave() override;
    bool takesKey(const QKeyEvent& event) const override;
    void keyPress(const QKeyEvent& event) override;
    bool undoStep() override;
    bool picksBranches() const override { return false; }
    bool hidesOverlay() const override { return true; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    StrokeMesh strokes(int heightPx) const override;
    void paint(QPainter& painter) const override;

signals:
    void activated();   ///< emitted when the mode starts; the receiver calls `setGuide`
    void editChanged(ui::CurveEdit edit);
    void edited(const core::Centerline2d& curves, const ui::LocalizedText& undoText);
    void suspectAccepted(int curveId);
    void deviceToggled(int curveId, bool isDevice);   ///< emitted when the curve was marked as a device, or unmarked

private:
    struct Sign;
    enum class Decision { Vessel, Device, Nothing };   ///< user's classification of a suspect curve

    double reachPx() const;   ///< picking tolerance in image px
    void eraseAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void report(const core::Centerline2d& curves, const LocalizedText& undoText);
    void setAnchor(const ToolPoint& point);
    void finishPath();
    std::vector<Eigen::Vector2d> outline() const;   ///< outline of the current region, image px
    std::vector<Sign> signs() const;
    bool clickSign(const ToolPoint& point);
    bool usesBrush() const;
    double brushPx() const;   ///< brush radius in image px
    bool isSuspectKey(const QKeyEvent& event) const;
    void suspectKey(const QKeyEvent& event);
    void chooseSuspect(int step);
    void decide(int curveId, Decision decision);
    void markDevice(int curveId);
    CurveStyle idleStyle() const;
    void setShown(core::Centerline2d curves);
    CurveCanvas canvas(int heightPx) const;
    void addTouched(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addPicked(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addRegion(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addPath(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addBrush(StrokeMesh& mesh, const CurveCanvas& canvas) const;

    core::Centerline2d curves_;
    core::Centerline2d shownCurves_;   ///< curves including the effect of the current drag
    int shownRevision_ = 0;
    mutable CurveStrokeCache idleStrokes_;
    CurveMarks marks_;
    int chosenSuspect_ = -1;   ///< ID of the suspect curve selected with keys; −1 if none
    std::shared_ptr<CurveGuide> guide_;
    bool isReady_ = false;
    CurveEdit edit_ = CurveEdit::Remove;
    double brushRadius_ = 14.0;
    std::optional<ToolPoint> pointer_;
    int hovered_ = -1;
    bool isDragging_ = false;
    bool keepsInside_ = true;   ///< if true, the region keeps only its inside (Ctrl); otherwise its inside is removed
    std::vector<Eigen::Vector2d> region_;
    LiveWirePath path_;
};

}   // namespace angiopose::ui
