#pragma once

#include "core/render/renderer.h"
#include "core/texture/layers/brush_stroke.h"
#include "widgets/view/brush_outline.h"
#include "widgets/view/camera_controller.h"
#include "widgets/view/dragging.h"
#include "widgets/view/marks.h"
#include "widgets/view/overlay.h"
#include "widgets/view/picking.h"
#include "widgets/view/view_tool.h"

#include <QOpenGLWidget>
#include <QSurfaceFormat>

#include <exception>
#include <memory>
#include <optional>

namespace esm {

/// The kind of surface that the view draws on; a program makes it the default before its first window.
QSurfaceFormat viewFormat();

/// A landmark on the organ at rest.
struct OrganMark {
    Eigen::Vector3d point; ///< m
    MarkLook look;
};

/// Shows an organ and what stands around it; tells what the user does to it. Knows no document: a scene goes
/// in, intents come out, and nothing moves until a new scene says so. Only the camera and the sphere
/// instrument in the user's hand are the view's own.
///
/// Esc lets go of what is held; every other key is the window's.
class OrganView : public QOpenGLWidget {
    Q_OBJECT

public:
    explicit OrganView(QWidget* parent = nullptr);
    ~OrganView() override;

    /// Replaces all that is shown. The first scene with anything in it is framed.
    void setScene(RenderScene scene);
    const RenderScene& scene() const { return m_scene; }
    /// Replaces only the nodes' positions, as a running simulation gives them.
    void setNodePositions(std::vector<Eigen::Vector3d> positions);

    void setLegend(std::optional<ViewLegend> legend);
    /// Shown with the tool Landmark.
    void setMarks(std::vector<OrganMark> marks);
    /// The line at the bottom; empty shows the tool's own.
    void setHint(const QString& hint);
    QString hint() const { return m_hint.isEmpty() ? toolHint(m_tool) : m_hint; }

    ViewTool tool() const { return m_tool; }
    void setTool(ViewTool tool);
    /// Ends a drag and takes the instrument away, as Esc does.
    void letGo();
    void setInstrumentRadius(double metres);
    double instrumentRadius() const { return m_instrumentRadius; }
    /// Shown with the tool Brush, on the surface under the mouse.
    void setBrush(const ViewBrush& brush);

    const Camera& camera() const { return m_cameraController.camera(); }
    void setCamera(const Camera& camera);
    void showView(StandardView view);
    /// Keeps the line of sight and shows the whole organ.
    void frameOrgan();

signals:
    void toolChanged(esm::ViewTool tool);
    void cameraChanged();
    /// A picture was drawn.
    void drawn();
    /// A click on the surface, with the tool Select or Region.
    void pointPicked(quint32 node, const Eigen::Vector3d& point);
    /// A click on the surface with the tool Place: where a region is to lie, on the organ at rest.
    /// @param anew a new one, whichever is selected
    void spotPicked(const esm::SurfaceSpot& spot, bool anew);
    void regionPicked(int index);
    /// A click on the surface with the tool Landmark, on the organ at rest.
    void landmarkPicked(const Eigen::Vector3d& point);
    void markSelected(int number);
    /// Where on the organ at rest the drag takes a mark; again and again until `markDropped`.
    void markDragged(int number, const Eigen::Vector3d& point);
    void markDropped();
    /// A node is to follow the mouse: target in m. `pullReleased` always ends what `pullStarted` began.
    void pullStarted(quint32 node);
    void pullMoved(quint32 node, const Eigen::Vector3d& target);
    void pullReleased();
    void instrumentMoved(const Eigen::Vector3d& centre);
    void instrumentRemoved();
    /// What the drag makes of the scene's ellipsoid or projector; again and again until `dragFinished`.
    void regionDragged(int index, const esm::Ellipsoid& shape);
    void rimDragged(int index, double metres);
    void projectorDragged(int index, const esm::Projector& projector);
    void dragFinished();
    /// The brush is led over the organ at rest; `brushLifted` or, by Esc, `brushDropped` ends what
    /// `brushStarted` began.
    void brushStarted(const esm::BrushPoint& point);
    void brushMoved(const esm::BrushPoint& point);
    void brushLifted();
    void brushDropped();
    /// A click with Ctrl and the tool Brush.
    void brushSourcePicked(const esm::BrushPoint& point);

protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    double aspect() const;
    Ray rayAt(const QPointF& place) const;
    std::optional<QPointF> placeOf(const Eigen::Vector3d& point) const;
    Eigen::AlignedBox3d organBox() const;
    void applyCamera(const Camera& camera);

    std::optional<Drag> dragAt(const QPointF& place);
    std::optional<Drag> regionDragAt(const QPointF& place, const Ray& ray) const;
    std::optional<Drag> projectorDragAt(const QPointF& place, const Ray& ray) const;
    std::optional<Drag> cornerDragAt(const QPointF& place) const;
    bool drawsCornerFreely(const QMouseEvent& event) const;
    void followDrag(const QPointF& place, Proportions proportions);
    void endDrag();
    void click(const QMouseEvent& event);
    void clickSpot(const QPointF& place, bool anew);
    void clickLandmark(const QPointF& place);
    std::optional<PickedPoint> pickAt(const QPointF& place);
    /// The place under the mouse that the brush is led over; nothing beside the surface.
    std::optional<BrushPoint> brushPointAt(const QPointF& place);
    void dropStroke();
    void paintBrushTool(QPainter& painter);
    QPolygonF seen(const std::vector<Eigen::Vector3d>& points) const;
    void moveInstrument(const QPointF& place);
    void pushInstrument(double notches, const QPointF& place);
    void removeInstrument();
    void showInstrument();

    /// The size of a pixel of the picture at a point of space, m.
    double pixelAt(const Eigen::Vector3d& point) const;
    /// Those of the selected region.
    std::vector<RegionHandle> shownRegionHandles() const;
    std::optional<RegionHandle> regionHandleAt(const QPointF& place) const;
    std::vector<PaintedHandle> paintedRegionHandles() const;
    std::vector<PaintedHandle> projectorHandles() const;
    std::vector<PaintedMark> paintedMarks();
    void drawScene();
    void paintOverlay();
    static QString cannotBeShown(const std::exception& problem);
    void dropRenderer();

    RenderScene m_scene;
    std::unique_ptr<Renderer> m_renderer;
    QString m_problem; ///< why nothing can be drawn
    CameraController m_cameraController;
    Picker m_picker;
    ViewTool m_tool = ViewTool::Select;
    std::optional<ViewLegend> m_legend;
    QString m_hint;
    std::vector<OrganMark> m_marks;
    std::optional<Drag> m_drag;
    std::optional<QPointF> m_pressed; ///< where the left button went down, while it may still become a click
    double m_instrumentRadius = 0.01; ///< m
    std::optional<Eigen::Vector3d> m_instrument; ///< centre, m
    bool m_instrumentPushed = false;             ///< moves at its depth instead of along the surface
    ViewBrush m_brush;
    std::optional<PickedPoint> m_brushAt; ///< under the mouse, as it was last moved
    bool m_framed = false;
};

} // namespace esm
