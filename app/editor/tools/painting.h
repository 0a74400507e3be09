#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"

namespace esm {

/// The brush that is led over the selected layer, and the stroke that it makes: one undoable step, seen while
/// it grows.
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
    void setBrush(const Brush& brush);
    /// Where a clone brush takes its colours, on the organ at rest.
    const std::optional<Eigen::Vector3d>& source() const { return m_source; }
    void setSource(const BrushPoint& point);

    void begin(const BrushPoint& point);
    /// Points close to the one before are left out.
    void goOn(const BrushPoint& point);
    void finish();
    /// Takes back the stroke that is being painted, and nothing else.
    void drop();

signals:
    void changed();
    /// Why nothing is painted, or will be seen.
    void message(const QString& text);

private:
    void follow(const Change& change);
    QString refusal() const;
    QString warning() const;
    void edit();
    bool isLaid() const;
    bool isLastStep() const;

    Document& m_document;
    Selection& m_selection;
    Brush m_brush;                             ///< its kind is that of a photo's layer
    BrushKind m_paintKind = BrushKind::Colour; ///< of a layer without photo
    std::optional<Eigen::Vector3d> m_source;
    std::optional<BrushStroke> m_stroke;       ///< while the brush is down
    std::shared_ptr<const BrushStroke> m_laid; ///< the same, as the layer holds it
    LayerId m_layer;                           ///< that it is painted on
    int m_gesture = 0;
};

} // namespace esm
