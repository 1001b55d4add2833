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

/// The shown image, which all tools are about, or one that stands beside it.
enum class ImageRole { Working, Beside };

/// What the pointer in another image, or in this one, means here.
struct ImageCrosshair {
    std::optional<core::ImageSegment> linePx;   ///< where what lies under it may be
    std::optional<Eigen::Vector3d> pointInPatient;   ///< the place on the vessels under it
};

/// The angiogram with the projected tree: window/level, pan and zoom by dragging as the mouse preset says, zoom also by
/// Ctrl+wheel, frames by wheel, ↑ ↓, Home, End; a right click or the menu key asks for a menu. A tool may take the left
/// button and keys; Esc takes its drag back, then puts it away. Shows what it is told, reports what the user wants;
/// decides nothing. Angiogram with tree, and what lies over them, are drawn in two turns of the event loop; painting
/// the window is but a copy of both.
class AngiogramView : public QWidget {
    Q_OBJECT
public:
    explicit AngiogramView(ImageRole role = ImageRole::Working, QWidget* parent = nullptr);
    ~AngiogramView() override;

    OverlayScene& scene() { return scene_; }   ///< call redraw() after changing it
    void redraw();   ///< asks for a new picture; update() copies the last one
    void setPivot(const Eigen::Vector3d& pivotInPatient);   ///< centroid of the tree: where ring and cross sit, …
    void setPickedPivot(const std::optional<Eigen::Vector3d>& pickedInPatient);   ///< … unless picked; marked then
    void setPose(const core::RigidTransform& cameraFromPatient);
    void setCamera(const core::ProjectionCamera& camera);
    void setFrame(const core::ImageF& frame);   ///< keeps zoom and window/level when the size stays
    void setFramePosition(int index, int count);   ///< shown bottom left, counted from 0; a count below 2 hides it
    void setCornerTexts(const CornerTexts& texts);   ///< the view adds its own lines at the bottom left
    void setTool(ImageTool* tool);   ///< null: none
    ImageTool* tool() const;
    void addBar(QWidget* bar);   ///< of a tool: at the bottom of the image, in the middle
    bool filterToolKey(QKeyEvent& event);   ///< true when the key is the tool's, or an Esc that it ends by
    void setKeptOut(const core::Mask2d& fieldMask);   ///< hatches where it is 0; empty: nothing
    void setMousePreset(const MousePreset& preset);
    void setResidualScale(double maximumPx, double maximumMm);   ///< 0 hides the scale
    void setLineWidth(double px);   ///< device-independent px
    void setCrosshair(const ImageCrosshair& crosshair);
    const ImageCrosshair& crosshair() const;
    void setMarks(std::vector<ImageMark> marks);   ///< measured; drawn above everything but the tool's
    const std::vector<ImageMark>& marks() const;
    void setPlacedMarks(std::vector<ImageMark> marks);   ///< likewise: places of the vessels, arrows, words
    const std::vector<ImageMark>& placedMarks() const;
    void setAbsence(const QString& words);   ///< said in place of an image
    void takeLookOf(const AngiogramView& other);   ///< lines, marks, mirror, mouse: not what is shown, nor how bright
    void setCutout(Cutout::Shape shape);   ///< follows the mouse
    Cutout::Shape cutout() const { return cutout_; }
    void setOrientationKnown(bool known);   ///< letters at the edges tell where the patient's sides are
    void setFromSource(bool fromSource);   ///< mirrors what is seen, and nothing else
    bool isFromSource() const;
    void fitToWindow();
    void zoomTo(const ViewRect& part);   ///< image px; leaves room around it
    void showPart(const ViewRect& part);   ///< image px; as large as the window allows
    void autoWindowLevel();
    void setWindowLevel(double window, double level);
    core::DisplayRange shownRange() const;
    ViewRect visiblePart() const;   ///< of the image
    bool isFitted() const;
    double zoom() const;   ///< device-independent px per image px
    const core::ProjectionCamera& camera() const;
    const core::RigidTransform& cameraFromPatient() const;
    const Eigen::Vector3d& pivotInPatient() const;   ///< picked, or the centroid
    std::optional<QPointF> placeOf(const Eigen::Vector3d& pointInPatient) const;   ///< widget px, where it is seen
    int renderCount() const { return renderCount_; }   ///< how often it drew itself
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    Eigen::Vector2d imageFromWidget(const QPointF& position) const;
    QPointF widgetFromImage(const Eigen::Vector2d& imagePoint) const;

signals:
    void frameStepRequested(int step);   ///< ±1, ±10; INT_MIN first, INT_MAX last
    void pointed(const std::optional<Eigen::Vector2d>& imagePx);   ///< the mouse is there, or left the image
    void branchHovered(std::optional<int> branchId);
    void branchClicked(int branchId, Qt::KeyboardModifiers modifiers);
    void backgroundClicked();
    void roomRequested();   ///< a double click that no tool took: large, or back
    void menuRequested(const QPoint& globalPosition, std::optional<int> branchId);
    void toolChanged();   ///< `tool`
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
    bool cancelDrag();   ///< true when there was one
    bool escape();
    void click(const QPointF& position, Qt::KeyboardModifiers modifiers);
    std::optional<int> branchAt(const QPointF& position) const;
    void hoverAt(const QPointF& position);
    void hover(std::optional<int> branchId);
    void showCursor();

    OverlayScene scene_;
    /// What the picture was drawn from.
    struct PictureState {
        OverlayScene::Stamp scene;
        bool isMirrored = false;

        bool operator==(const PictureState&) const = default;
    };
    OverlayPainter painter_;
    std::unique_ptr<GlOverlay> gl_;   ///< draws instead of the painter where it was chosen
    bool isRendererKnown_ = false;
    QImage picture_;   ///< angiogram with tree and handles, in device px
    std::optional<PictureState> drawn_;   ///< not set: with a tool, whose strokes change at will
    QImage whole_;   ///< with all that lies over it: what is painted; null: not drawn since it was out of sight
    std::vector<QRectF> barsInWhole_;   ///< which it leaves room for
    QTimer turnTimer_;
    Turn nextTurn_ = Turn::Picture;
    bool isRedrawDue_ = false;   ///< something changed since the last picture was begun
    int renderCount_ = 0;
    std::unique_ptr<Interaction> interaction_;
    Cutout::Shape cutout_ = Cutout::Shape::None;
};

}   // namespace angiopose::ui