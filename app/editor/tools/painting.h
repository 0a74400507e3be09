#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "core/surface/surface_query.h"

namespace esm {

/// The brush on the surface.
struct BrushTouch {
    BrushPoint point;
    std::optional<double> pressure{}; ///< of a tablet's pen, 0 to 1; none of a mouse
};

/// What the pressure of a pen changes.
struct PressureUse {
    bool size = true, strength = false;
};

/// The brush that is led over the selected layer, and what it paints while it is down: one undoable step,
/// seen while it grows. Where the brush leaves the surface and comes back, a stroke of its own goes on.
class Painting : public QObject {
    Q_OBJECT

public:
    /// Kind, radius, softness, strength and colour; without a path.
    using Brush = BrushStroke;

    Painting(Document& document, Selection& selection, QObject* parent = nullptr);

    const TextureLayer* layer() const; ///< that is selected; null without one
    /// Those that the selected layer takes: a photo is only erased and restored.
    std::vector<BrushKind> kinds() const;
    /// As it paints on the selected layer; of the kind chosen last among those that the layer takes.
    Brush brush() const;
    /// No larger than the organ: see largestRadius().
    void setBrush(const Brush& brush);
    /// m, half of the organ's diagonal: a brush that covers all of it.
    double largestRadius() const;
    /// Where a brush that copies takes its colours, on the organ at rest.
    const std::optional<Eigen::Vector3d>& source() const { return m_source; }
    void setSource(const BrushPoint& point);

    const PressureUse& pressureUse() const { return m_pressureUse; }
    void setPressureUse(const PressureUse& use);
    /// What a pressure leaves of the brush; all of it without a pen.
    BrushShares sharesAt(std::optional<double> pressure) const;

    void begin(const BrushTouch& touch);
    /// Nothing stands where the brush left the surface. Points close to the one before are left out; a pen
    /// that presses harder there makes that one stronger.
    void goOn(const std::vector<std::optional<BrushTouch>>& touches);
    void finish();
    /// Takes back what is being painted, and nothing else.
    void drop();

signals:
    void changed();
    /// Why nothing is painted, or will be seen.
    void message(const QString& text);

private:
    /// Of the brush, while it is down.
    struct Movement {
        LayerId layer; ///< that it paints on
        std::vector<BrushStroke> strokes;
        std::vector<std::shared_ptr<const BrushStroke>> laid; ///< the same, as the layer holds them
        bool isOff = false;                                   ///< the brush is beside the surface
        bool isPressed = false;                               ///< shares go by a pen's pressure
    };

    void follow(const Change& change);
    QString refusal() const;
    /// Why nothing of the stroke is seen that begins there; empty where something is.
    QString warning(const BrushPoint& point);
    const SurfaceQuery& surface();
    bool extend(const std::optional<BrushTouch>& touch);
    void append(const BrushTouch& touch);
    bool isFull() const;
    void edit();
    bool isLaid() const;
    bool isLastStep() const;
    MergeKey keyOf(LayerId layer) const;

    Document& m_document;
    Selection& m_selection;
    Brush m_brush;                             ///< its kind is that of a photo's layer
    BrushKind m_paintKind = BrushKind::Colour; ///< of a layer without photo
    PressureUse m_pressureUse;
    std::optional<Eigen::Vector3d> m_source;
    std::optional<Movement> m_movement;
    std::optional<SurfaceQuery> m_surface; ///< of the organ at rest, once it was asked for
    int m_gesture = 0;
};

} // namespace esm
