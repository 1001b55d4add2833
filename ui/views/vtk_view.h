#pragma once

#include <QOpenGLWidget>

#include <memory>

class QPainter;
class vtkRenderWindow;

namespace ui {

/// A VTK render window inside a Qt 6 window. Redraws are asked for with update() and happen once per frame.
/// The program sets Qt::AA_ShareOpenGLContexts before it makes its QApplication.
class VtkView : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit VtkView(QWidget* parent = nullptr);
    ~VtkView() override;

    vtkRenderWindow* renderWindow() const;
    QSize sizeHint() const override { return {480, 360}; }
    QSize minimumSizeHint() const override { return {80, 80}; }
    QSize deviceSize() const;   ///< in device pixels
    int contextCount() const { return contextCount_; }   ///< how often a context was taken over
    int renderCount() const { return renderCount_; }

protected:
    /// Called in every redraw before VTK draws: the place to bring the scene up to date.
    virtual void prepareFrame() {}
    /// Called in every redraw on top of what VTK drew, in device-independent pixels.
    virtual void paintAnnotations(QPainter& painter);

    void initializeGL() override;
    void paintGL() override;

private:
    struct Glue;
    void releaseContext();
    void blitToWidget();
    void paintOverOpenGl();

    std::unique_ptr<Glue> glue_;
    int contextCount_ = 0;
    int renderCount_ = 0;
    bool isPainting_ = false;
};

}   // namespace ui
