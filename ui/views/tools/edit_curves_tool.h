#pragma once

#include "core/tracing/angiogram/drawing/live_wire.h"
#include "core/vessel/centerline2d.h"
#include "ui/scenes/stroke_mesh.h"
#include "ui/views/image_tool.h"
#include "ui/views/tools/curve_strokes.h"
#include "ui/views/tools/wire_path.h"
#include "ui/words/spoken.h"

#include <memory>
#include <vector>

namespace angiopose::ui {

enum class CurveEdit { Erase, Draw, Cut, Remove, Apart, Box, Lasso };

/// What is known of curves beside their course, by id.
struct CurveMarks {
    std::vector<int> suspects = {};   ///< may be catheters, wires or edges of bones
    std::vector<int> devices = {};   ///< are catheters or wires, says the user
};

/// What the live wire follows, and what drawn curves are centred on.
struct CurveGround {
    core::LiveWire wire;
    core::ImageF opacity;
    double maxRadiusPx = 8.0;
};

/// Edits the traced curves of the frame by mouse: see `CurveEdit`. Curves that may be catheters are dashed amber, with
/// a tick, a wire and a cross to click; S goes to the next of them, A keeps it, W keeps it apart as a catheter or wire,
/// Delete leaves it out. Catheters and wires are dashed white. Shows the curves it is told, and reports what they would
/// be after each edit.
class EditCurvesTool : public ImageTool {
    Q_OBJECT
public:
    explicit EditCurvesTool(AngiogramView& view);
    ~EditCurvesTool() override;

    void showCurves(const core::Centerline2d& curves, CurveMarks marks);   ///< ends what is under way
    void setReady(bool ready);   ///< false while the frame is being traced: nothing can be edited yet
    void setGround(std::shared_ptr<CurveGround> ground);   ///< null: not there yet, drawn lines are straight
    bool hasGround() const { return ground_ != nullptr; }
    void setEdit(CurveEdit edit);
    CurveEdit edit() const { return edit_; }
    void setBrush(double radius);   ///< widget px
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
    bool takeBack() override;
    bool picksBranches() const override { return false; }
    bool hidesOverlay() const override { return true; }
    std::optional<QCursor> cursor(bool isDragging) const override;
    StrokeMesh strokes(int heightPx) const override;
    void paint(QPainter& painter) const override;

signals:
    void begun();   ///< the mode is on: a ground is wanted
    void editChanged(ui::CurveEdit edit);
    void edited(const core::Centerline2d& curves, const ui::Words& what);
    void suspectAccepted(int curveId);
    void keptApart(int curveId, bool apart);   ///< as a catheter or wire, or a vessel again

private:
    struct Sign;
    enum class Decision { Vessel, Device, Nothing };   ///< what a suspect is

    double reachPx() const;   ///< image px
    void eraseAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void report(const core::Centerline2d& curves, const Words& what);
    void setAnchor(const ToolPoint& point);
    void finishPath();
    std::vector<Eigen::Vector2d> outline() const;   ///< of the region under way, image px
    std::vector<Sign> signs() const;
    bool clickSign(const ToolPoint& point);
    bool brushes() const;
    double brushPx() const;   ///< its radius in image px
    bool isSuspectKey(const QKeyEvent& event) const;
    void suspectKey(const QKeyEvent& event);
    void chooseSuspect(int step);
    void decide(int curveId, Decision decision);
    void keepApart(int curveId);
    CurveLook lookAtRest() const;
    void setShown(core::Centerline2d curves);
    CurveCanvas canvas(int heightPx) const;
    void addTouched(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addPicked(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addRegion(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addPath(StrokeMesh& mesh, const CurveCanvas& canvas) const;
    void addBrush(StrokeMesh& mesh, const CurveCanvas& canvas) const;

    core::Centerline2d curves_;
    core::Centerline2d shown_;   ///< with the drag under way
    int shownRevision_ = 0;
    mutable KeptCurveStrokes strokesAtRest_;
    CurveMarks marks_;
    int chosenSuspect_ = -1;   ///< by keys; −1: none
    std::shared_ptr<CurveGround> ground_;
    bool isReady_ = false;
    CurveEdit edit_ = CurveEdit::Remove;
    double brushRadius_ = 14.0;
    std::optional<ToolPoint> mouse_;
    int hovered_ = -1;
    bool isDragging_ = false;
    bool isKeeping_ = true;   ///< a region keeps what is in it, with Ctrl what is outside
    std::vector<Eigen::Vector2d> region_;
    WirePath path_;
};

}   // namespace angiopose::ui