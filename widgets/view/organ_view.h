#pragma once

#include "core/render/renderer.h"
#include "widgets/inputs/key_pointer.h"
#include "widgets/inputs/spoken.h"
#include "widgets/view/camera_controller.h"
#include "widgets/view/overlay.h"
#include "widgets/view/picture_maker.h"
#include "widgets/view/view_tool.h"

#include <QWidget>

#include <functional>
#include <optional>

namespace esm {

/// Shows an organ and what stands around it, and hands mouse and wheel to the tool in hand. Knows no document
/// and no tool: a scene goes in, and nothing moves until a new scene says so. Only the camera is the view's
/// own.
///
/// Esc lets go of what is held; arrows, Enter, Tab and Page Up and Down work as the mouse does (KeyPointer);
/// every other key is the window's.
class OrganView : public QWidget, public Spoken {
    Q_OBJECT

public:
    /// @param drawing of its pictures, as the maker's
    explicit OrganView(QWidget* parent = nullptr, PictureDrawing drawing = {});

    /// Replaces all that is shown. The first scene with anything in it is framed.
    void setScene(RenderScene scene);
    const RenderScene& scene() const { return m_scene; }
    /// Changes a part of what is shown. Mesh, network and the nodes' positions have to stay: what is picked
    /// is found by them.
    void changeScene(const std::function<void(RenderScene&)>& change);
    /// Whether its picture shows the scene as it is now, with smooth edges.
    bool isUpToDate() const;
    /// Replaces only the nodes' positions, as a running simulation gives them.
    void setNodePositions(std::vector<Eigen::Vector3d> positions);
    /// Those that the scene leads.
    void setInstruments(std::vector<PlacedCollider> instruments);
    /// What stands beside them, in their order.
    void setInstrumentNames(QStringList names);

    void setLegend(std::optional<ViewLegend> legend);
    /// The line at the bottom.
    void setHint(const QString& hint);
    const QString& hint() const { return m_hint; }

    /// From where the organ is seen, what its colours mean, and what the tool in hand does.
    QString spokenValue() const override;

    const ViewTool& tool() const { return *m_tool; }
    /// Takes a tool in hand, which outlives the view's use of it.
    void setTool(ViewTool& tool);
    /// For the moment only.
    Sight sight();
    bool isHolding() const { return m_hold != Hold::Nothing; }
    /// Ends a drag, as when the button comes up.
    void letGo();
    /// What Esc does.
    void cancel();

    const Camera& camera() const { return m_cameraController.camera(); }
    /// From outside; so do all that follow but lookFromWithin().
    void setCamera(const Camera& camera);
    void showView(StandardView view);
    /// Keeps the line of sight and shows the whole organ. Until the user comes nearer, goes farther or shifts
    /// the view, it stays whole whatever the view's size.
    void frameOrgan();
    /// The same with a box, from outside the surface.
    void frame(const Eigen::AlignedBox3d& box);
    /// With the same framing.
    void setOrthographic(bool on);
    bool isOrthographic() const { return outsideCamera().orthographicHeight.has_value(); }

    /// Puts the eye inside the organ, where the mouse looks around: see cameraWithin(). Where there is no
    /// room as asked for, it is sought under the mouse. False where there is none.
    bool lookFromWithin(const std::optional<Eigen::Vector3d>& about);
    /// To where lookFromWithin() found the camera.
    void leaveWithin();
    bool isWithin() const { return m_outside.has_value(); }

    /// Puts the eye where another lens looked from. What brings the organ into view again, or changes the
    /// projection, goes back to the lens from before.
    void lookThrough(const Camera& camera);
    /// To where lookThrough() found the camera.
    void leaveThrough();
    /// Whether it was not moved since.
    bool isThrough() const;

signals:
    void toolChanged();
    void cameraChanged();
    /// The first picture of what the view was to show came.
    void drawn();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool focusNextPrevChild(bool next) override;
    void leaveEvent(QEvent* event) override;

private:
    double aspect() const;
    ToolMouse mouseOf(const QMouseEvent& event);
    Eigen::AlignedBox3d organBox() const;
    void applyCamera(const Camera& camera);
    void putCamera(const Camera& camera, const std::optional<Camera>& outside);
    Camera outsideCamera() const;
    void moveTool(const ToolMouse& mouse);
    void followTool();

    void redraw();
    bool showsWholeOrgan() const;
    void askForPicture();
    void takePicture();
    void paintOverlay(QPainter& painter);
    void nameInstruments(QPainter& painter, const Camera& shown);

    RenderScene m_scene;
    PictureMaker m_maker;
    MadePicture m_picture;   ///< that is shown
    int m_asked = 0;         ///< number of the picture that was asked for last
    double m_askedRatio = 0; ///< its pixels per pixel of the design
    bool m_isStale = true;   ///< what was asked for last is no longer what is to be shown
    CameraController m_cameraController;
    std::optional<Camera> m_outside; ///< where the camera was before it looked from within
    /// Where it was before it looked through another lens, and where that put it.
    std::optional<Camera> m_former, m_through;
    Picker m_picker;
    ViewTool m_noTool;
    ViewTool* m_tool = &m_noTool;
    Hold m_hold = Hold::Nothing;      ///< of the tool's last press
    std::optional<double> m_pressure; ///< of a tablet's pen while it is down
    std::optional<QPointF> m_pressed; ///< where the left button went down, while it may still become a click
    std::optional<ViewLegend> m_legend;
    QString m_hint;
    QStringList m_instrumentNames;
    bool m_framed = false;
    std::optional<Camera> m_whole; ///< that showed the whole organ last
    KeyPointer m_keyPointer{*this};
};

} // namespace esm
