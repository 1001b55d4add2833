#pragma once

#include "core/geometry/epipolar_line.h"
#include "core/imaging/display_range.h"
#include "ui/actions/mouse_preset.h"
#include "ui/scenes/image_mark.h"
#include "ui/scenes/overlay_painter.h"
#include "ui/scenes/render_offscreen.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>

class QPainter;

namespace angiopose::ui {

class GlOverlay;
class ImageTool;

/// `Working` is the current image, on which all tools act; `Secondary` is another image next to it.
enum class ImageRole { Working, Secondary };

/// Linked crosshair in this image, mapped from the pointer position in this or another image.
struct ImageCrosshair {
    std::optional<core::ImageSegment> linePx;   ///< epipolar line of the pointer position
    std::optional<Eigen::Vector3d> pointInPatient;   ///< vessel point under the pointer
};

/// View of the angiogram with the projected tree. Drags adjust window/level, pan and zoom according to the mouse
/// preset; Ctrl+wheel zooms; the wheel, ↑ ↓, Home and End select frames; a right click or the menu key requests a
/// context menu. A tool can take over the left button and keys; Esc cancels its drag, then ends the tool. Passive view:
/// displays the given state and emits signals for user actions. The angiogram with the tree and the annotations are
/// drawn in two turns of the event loop; painting the widget only copies the result.
class AngiogramView : public QWidget {
    Q_OBJECT
public:
    explicit AngiogramView(ImageRole role = ImageRole::Working, QWidget* parent = nullptr);
    ~AngiogramView() override;

    OverlayScene& scene() { return scene_; }   ///< call redraw() after changing the scene
    void redraw();   ///< schedules a new rendering; update() only copies the last one
    void setPivot(const Eigen::Vector3d& pivotInPatient);   ///< centroid of the tree, at which the handles appear
    void setPickedPivot(const std::optional<Eigen::Vector3d>& pickedInPatient);   ///< replaces the centroid
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setCamera(const core::ProjectionCamera& camera);
    void setFrame(const core::ImageF& frame);   ///< keeps zoom and window/level if the size is unchanged
    void setFramePosition(int index, int count);   ///< at the bottom left; `index` starts at 0; hidden if count < 2
    void setCornerTexts(const CornerTexts& texts);   ///< the view adds its own lines in the lower left corner
    void setTool(ImageTool* tool);   ///< null for no tool
    ImageTool* tool() const;
    void addBar(QWidget* bar);   ///< adds the toolbar of a tool, at the bottom center of the image
    bool filterToolKey(QKeyEvent& event);   ///< true if the tool handles the key, or if Esc cancels or ends the tool
    void setExcludedArea(const core::Mask2d& fieldMask);   ///< hatches pixels with value 0; empty hatches none
    void setMousePreset(const MousePreset& preset);
    void setResidualScale(double maximumPx, double maximumMm);   ///< a `maximumPx` of 0 hides the scale
    void setLineWidth(double px);   ///< width in device-independent px
    void setCrosshair(const ImageCrosshair& crosshair);
    const ImageCrosshair& crosshair() const;
    void setMarks(std::vector<ImageMark> marks);   ///< sets the measurements, drawn above the tree and below the tool
    const std::vector<ImageMark>& marks() const;
    void setPlacedMarks(std::vector<ImageMark> marks);   ///< locations, arrows and text annotations, drawn like marks
    const std::vector<ImageMark>& placedMarks() const;
    void setPlaceholderText(const QString& text);   ///< sets the text shown without an image
    void copyAppearance(
        const AngiogramView& other);   ///< copies lines, marks, mirroring and mouse preset, but not the content
    void setCutout(Cutout::Shape shape);   ///< the cutout follows the pointer
    Cutout::Shape cutout() const { return cutout_; }
    void setOrientationKnown(bool known);   ///< if true, orientation letters appear at the edges
    void setFromSource(bool fromSource);   ///< mirrors the display only, not the data
    bool isFromSource() const;
    void fitToWindow();
    void zoomTo(const ViewRect& part);   ///< `part` is in image px; leaves a margin around it
    void showPart(const ViewRect& part);   ///< `part` is in image px; shown as large as possible
    void autoWindowLevel();
    void setWindowLevel(double window, double level);
    core::DisplayRange shownRange() const;
    ViewRect visiblePart() const;   ///< visible part of the image, image px
    bool isFitted() const;
    double zoom() const;   ///< device-independent px per image px
    const core::ProjectionCamera& camera() const;
    const core::RigidTransform& cameraFromPatient() const;
    const Eigen::Vector3d& pivotInPatient() const;   ///< picked pivot, or the centroid
    std::optional<QPointF> positionOf(
        const Eigen::Vector3d& pointInPatient) const;   ///< returns widget px; nullopt if not visible
    int renderCount() const { return renderCount_; }   ///< number of renderings so far
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    Eigen::Vector2d imageFromWidget(const QPointF& position) const;
    QPointF widgetFromImage(const Eigen::Vector2d& imagePoint) const;

signals:
    void frameStepRequested(int step);   ///< ±1 or ±10 frames; INT_MIN stands for the first frame, INT_MAX for the last
    void pointerMoved(const std::optional<Eigen::Vector2d>& imagePx);   ///< pointer position; nullopt outside the image
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void backgroundClicked();
    void enlargeRequested();   ///< emitted on a double-click that no tool handles, to toggle maximizing
    void menuRequested(const QPoint& globalPosition, std::optional<int> branchId);
    void toolChanged();   ///< emitted when `tool` returns another tool
    void windowLevelChanged(double window, double level);
    void zoomChanged(double zoom);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    struct Interaction;
    enum class DrawStep { Image, Annotated };
    void drawNext();
    bool renderImage();
    void drawAnnotated();
    void paintOver(QPainter& painter);
    void updateAnnotations();
    void render(Canvas canvas, const StrokeMesh& above);
    void placeCutout(const QPointF& position);
    QSize deviceSize() const;
    QString sideMark() const;
    QString frameText() const;
    QString keyText() const;
    std::vector<QRectF> barRects() const;
    void dragBy(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void startDrag();
    void paintPivot(QPainter& painter) const;
    void paintPlaceholder(QPainter& painter) const;
    void paintCrosshair(QPainter& painter) const;
    void paintAllMarks(QPainter& painter) const;
    std::vector<ImageMark> visibleMarks() const;
    void strokeMarks();
    bool showsVessels() const;
    void adjustWindowLevel(const QPointF& step);
    void scrollFrames(double frames);
    void zoomAt(const QPointF& position, double factor);
    bool cancelDrag();   ///< returns true if a drag was canceled
    bool escape();
    void click(const QPointF& position, Qt::KeyboardModifiers modifiers);
    std::optional<int> branchAt(const QPointF& position) const;
    void hoverAt(const QPointF& position);
    void hover(std::optional<int> branchId);
    void showCursor();

    OverlayScene scene_;
    /// State of the scene and the view for which the image was rendered.
    struct ImageState {
        OverlayScene::Stamp scene;
        bool isMirrored = false;

        bool operator==(const ImageState&) const = default;
    };
    OverlayPainter painter_;
    std::unique_ptr<GlOverlay> gl_;   ///< replaces the painter if VTK renders
    bool isRendererKnown_ = false;
    QImage image_;   ///< angiogram with tree and handles, in device px
    std::optional<ImageState> drawnState_;   ///< nullopt while a tool is active, since its strokes change at any time
    QImage annotated_;   ///< image with annotations, as painted; null if not drawn since the view was hidden
    std::vector<QRectF> annotatedBars_;   ///< areas of the bars when `annotated_` was drawn
    QTimer drawTimer_;
    DrawStep nextStep_ = DrawStep::Image;
    bool isRedrawDue_ = false;   ///< true if the content has changed since the last rendering started
    int renderCount_ = 0;
    std::unique_ptr<Interaction> interaction_;
    Cutout::Shape cutout_ = Cutout::Shape::None;
};

}   // namespace angiopose::ui
