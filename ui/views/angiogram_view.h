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

/// Working: the current image, on which all tools act; Beside: an additional image.
enum class ImageRole { Working, Beside };

/// Position of the pointer, in this or another image, mapped to this image.
struct ImageCrosshair {
    std::optional<core::ImageSegment> linePx;   ///< epipolar line of the pointer position
    std::optional<Eigen::Vector3d> pointInPatient;   ///< vessel point under the pointer
};

/// Angiogram with the projected tree: window/level, pan and zoom by dragging according to the mouse preset, zoom also
/// by Ctrl+wheel, frames by wheel, ↑ ↓, Home, End; a right click or the menu key requests a context menu. A tool may
/// take the left button and keys; Esc cancels its drag, then ends the tool. Displays the values it is given and emits
/// signals for user actions; makes no decisions. The angiogram with tree and the annotations are drawn in two turns of
/// the event loop; painting the widget only copies the result.
class AngiogramView : public QWidget {
    Q_OBJECT
public:
    explicit AngiogramView(ImageRole role = ImageRole::Working, QWidget* parent = nullptr);
    ~AngiogramView() override;

    OverlayScene& scene() { return scene_; }   ///< call redraw() after changing it
    void redraw();   ///< schedules a new rendering; update() copies the last one
    void setPivot(const Eigen::Vector3d& pivotInPatient);   ///< centroid of the tree: position of ring and cross …
    void setPickedPivot(const std::optional<Eigen::Vector3d>& pickedInPatient);   ///< … unless picked, which is marked
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setCamera(const core::ProjectionCamera& camera);
    void setFrame(const core::ImageF& frame);   ///< keeps zoom and window/level if the size is unchanged
    void setFramePosition(int index, int count);   ///< shown bottom left, counted from 0; hidden if count < 2
    void setCornerTexts(const CornerTexts& texts);   ///< the view adds its own lines at the bottom left
    void setTool(ImageTool* tool);   ///< null: none
    ImageTool* tool() const;
    void addBar(QWidget* bar);   ///< toolbar of a tool, at the bottom center of the image
    bool filterToolKey(QKeyEvent& event);   ///< true if the tool takes the key, or Esc ends it
    void setKeptOut(const core::Mask2d& fieldMask);   ///< hatches pixels with value 0; empty: none
    void setMousePreset(const MousePreset& preset);
    void setResidualScale(double maximumPx, double maximumMm);   ///< 0 hides the scale
    void setLineWidth(double px);   ///< device-independent px
    void setCrosshair(const ImageCrosshair& crosshair);
    const ImageCrosshair& crosshair() const;
    void setMarks(std::vector<ImageMark> marks);   ///< measurements; drawn on top, below the tool
    const std::vector<ImageMark>& marks() const;
    void setPlacedMarks(std::vector<ImageMark> marks);   ///< vessel locations, arrows and texts, drawn like marks
    const std::vector<ImageMark>& placedMarks() const;
    void setAbsence(const QString& words);   ///< text shown if there is no image
    void takeLookOf(const AngiogramView& other);   ///< copies lines, marks, mirroring, mouse preset; not the content
    void setCutout(Cutout::Shape shape);   ///< follows the mouse
    Cutout::Shape cutout() const { return cutout_; }
    void setOrientationKnown(bool known);   ///< shows letters of the patient's sides at the edges
    void setFromSource(bool fromSource);   ///< mirrors the display only
    bool isFromSource() const;
    void fitToWindow();
    void zoomTo(const ViewRect& part);   ///< image px; adds a margin
    void showPart(const ViewRect& part);   ///< image px; as large as possible
    void autoWindowLevel();
    void setWindowLevel(double window, double level);
    core::DisplayRange shownRange() const;
    ViewRect visiblePart() const;   ///< image px
    bool isFitted() const;
    double zoom() const;   ///< device-independent px per image px
    const core::ProjectionCamera& camera() const;
    const core::RigidTransform& cameraFromPatient() const;
    const Eigen::Vector3d& pivotInPatient() const;   ///< picked pivot, or the centroid
    std::optional<QPointF> placeOf(const Eigen::Vector3d& pointInPatient) const;   ///< widget px; empty if not visible
    int renderCount() const { return renderCount_; }   ///< number of renderings so far
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    Eigen::Vector2d imageFromWidget(const QPointF& position) const;
    QPointF widgetFromImage(const Eigen::Vector2d& imagePoint) const;

signals:
    void frameStepRequested(int step);   ///< ±1, ±10; INT_MIN: first, INT_MAX: last
    void pointed(const std::optional<Eigen::Vector2d>& imagePx);   ///< mouse position; empty: it left the image
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void backgroundClicked();
    void roomRequested();   ///< double click not taken by a tool: toggle maximizing
    void menuRequested(const QPoint& globalPosition, std::optional<int> branchId);
    void toolChanged();   ///< see `tool`
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
    enum class Turn { Picture, Whole };
    void takeTurn();
    bool drawPicture();
    void drawWhole();
    void paintOver(QPainter& painter);
    void bringAnnotationsUpToDate();
    void render(Canvas canvas, const StrokeMesh& above);
    void placeCutout(const QPointF& position);
    QSize deviceSize() const;
    QString sideMark() const;
    QString frameText() const;
    QString keyText() const;
    std::vector<QRectF> barPlaces() const;
    void dragBy(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void startDrag();
    void paintPivot(QPainter& painter) const;
    void paintAbsence(QPainter& painter) const;
    void paintCrosshair(QPainter& painter) const;
    void paintAllMarks(QPainter& painter) const;
    std::vector<ImageMark> seenMarks() const;
    void strokeMarks();
    bool showsVessels() const;
    void adjustWindowLevel(const QPointF& step);
    void scrollFrames(double frames);
    void zoomAt(const QPointF& position, double factor);
    bool cancelDrag();   ///< true if a drag was canceled
    bool escape();
    void click(const QPointF& position, Qt::KeyboardModifiers modifiers);
    std::optional<int> branchAt(const QPointF& position) const;
    void hoverAt(const QPointF& position);
    void hover(std::optional<int> branchId);
    void showCursor();

    OverlayScene scene_;
    /// State from which the rendering was made.
    struct PictureState {
        OverlayScene::Stamp scene;
        bool isMirrored = false;

        bool operator==(const PictureState&) const = default;
    };
    OverlayPainter painter_;
    std::unique_ptr<GlOverlay> gl_;   ///< replaces the painter if VTK rendering was chosen
    bool isRendererKnown_ = false;
    QImage picture_;   ///< angiogram with tree and handles, in device px
    std::optional<PictureState> drawn_;   ///< empty with a tool, whose strokes change at any time
    QImage whole_;   ///< with annotations, as painted; null: not drawn since hidden
    std::vector<QRectF> barsInWhole_;   ///< bars that the annotations avoid
    QTimer turnTimer_;
    Turn nextTurn_ = Turn::Picture;
    bool isRedrawDue_ = false;   ///< changed since the last rendering started
    int renderCount_ = 0;
    std::unique_ptr<Interaction> interaction_;
    Cutout::Shape cutout_ = Cutout::Shape::None;
};

}   // namespace angiopose::ui